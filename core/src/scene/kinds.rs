//! The kinds of things that stand in lists of the scene itself, said once: a row each.
//!
//! From the rows are made what can be chosen ([`Thing`]), the edits of the lists, what is checked of ids and of what
//! hangs on what, deletion, the outline and the way from a problem to its thing. What a kind says of itself beyond its
//! row is [`InScene`], in the file of its type. So a new kind is a file, a list in [`Scene`] and a row here.

/// Gives the rows to the macro `$take`. What others hang on comes before them.
macro_rules! kinds {
    ($take:ident) => {
        $take! {
            /// A camera.
            Camera: Camera, CameraId, cameras, "camera", "Camera";
            /// A cloud model.
            Model: CloudModel, ModelId, models, "model", "Cloud model";
            /// A folder of clouds.
            Folder: Folder, FolderId, folders, "folder", "Folder";
            /// A placed cloud.
            Cloud: Cloud, CloudId, clouds, "cloud", "Cloud";
            /// A camera path.
            Path: CameraPath, PathId, paths, "path", "Path";
            /// An aircraft.
            Aircraft: Aircraft, AircraftId, aircraft, "aircraft", "Aircraft";
            /// A model that stands.
            Prop: Prop, PropId, props, "prop", "Prop";
            /// A track of keys.
            Track: Track, TrackId, tracks, "track", "Track";
        }
    };
}
pub(crate) use kinds;
