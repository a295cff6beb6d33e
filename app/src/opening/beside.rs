//! The files that a scene names, read from beside it: its atlas and the shapes of its aircraft and props.
//!
//! They are found and judged here, once, so that `check`, `render`, `fly` and the editor say the same about them. What is
//! built in stands in for a file with a problem.

use crate::storage;
use cloudwright_core::formats::model_glb;
use cloudwright_core::model_in_view::Meshes;
use cloudwright_core::problem::Problem;
use cloudwright_core::scene::Scene;
use cloudwright_core::sprites::Atlas;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// No sheet of 512 × 512 pixels is larger than this, bytes.
const MAX_ATLAS_BYTES: usize = 16 << 20;

/// Of models that were pasted: by their names, the scene file that they lie beside.
pub(crate) type Elsewhere = BTreeMap<String, PathBuf>;

/// What lies beside a scene's file and is drawn with it.
#[derive(Debug, Clone, Default)]
pub struct Beside {
    /// None for the built-in one.
    atlas: Option<Arc<Atlas>>,
    meshes: Meshes,
    names: Names,
    /// What is wrong with files, by their names.
    faults: BTreeMap<String, Problem>,
}

/// The names of a scene's files: the atlas, and the models of aircraft and props.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
struct Names {
    atlas: Option<String>,
    models: BTreeSet<String>,
}

impl Beside {
    /// What `scene` names, read from beside `scene_path`, and what is wrong with it: a file that isn't there, lies
    /// elsewhere, can't be read or is of another kind.
    pub fn read(scene: &Scene, scene_path: Option<&Path>) -> (Self, Vec<Problem>) {
        Self::read_with(scene, scene_path, &Elsewhere::new())
    }

    /// The same, where models that don't lie there may lie elsewhere.
    pub(crate) fn read_with(scene: &Scene, scene_path: Option<&Path>, elsewhere: &Elsewhere) -> (Self, Vec<Problem>) {
        let mut beside = Self { names: Names::of(scene), ..Self::default() };
        let mut problems = Vec::new();
        let mut fault = |faults: &mut BTreeMap<_, _>, name: &String, place: String, (message, hint): Trouble| {
            let problem = Problem::error(place, format!("“{name}”: {message}"), hint);
            problems.push(problem.clone());
            faults.insert(name.clone(), problem);
        };
        if let Some(name) = &beside.names.atlas {
            match atlas(name, scene_path) {
                Ok(atlas) => beside.atlas = Some(Arc::new(atlas)),
                Err(trouble) => fault(&mut beside.faults, name, "atlas".into(), trouble),
            }
        }
        for name in &beside.names.models {
            let (place, hint) = asker(name, scene);
            let other = elsewhere.get(name).map(PathBuf::as_path);
            let bytes = file(name, scene_path, model_glb::MAX_BYTES);
            match bytes
                .or_else(|trouble| file(name, other, model_glb::MAX_BYTES).map_err(|_| trouble))
                .and_then(|bytes| model_glb::read(&bytes).map_err(|error| (error.to_string(), hint)))
            {
                Ok(mesh) => beside.meshes.insert(name.clone(), mesh),
                Err(trouble) => fault(&mut beside.faults, name, place, trouble),
            }
        }
        (beside, problems)
    }

    /// Whether it is what `scene` names.
    pub(crate) fn is_of(&self, scene: &Scene) -> bool {
        self.names == Names::of(scene)
    }

    /// What is wrong with the file of that name.
    pub(crate) fn fault(&self, name: &str) -> Option<&Problem> {
        self.faults.get(name)
    }

    /// The sheet to draw with.
    pub fn sheet(&self) -> &Atlas {
        self.atlas.as_deref().unwrap_or_else(|| Atlas::built_in())
    }

    /// The shapes of aircraft and props.
    pub fn meshes(&self) -> &Meshes {
        &self.meshes
    }
}

/// A file that a scene names: what it is, its name, and how large it may be, bytes.
pub(crate) struct Named {
    pub(crate) what: &'static str,
    pub(crate) name: String,
    pub(crate) max_bytes: usize,
}

/// All files that `scene` names and that may lie beside it.
pub(crate) fn named(scene: &Scene) -> Vec<Named> {
    let Names { atlas, models } = Names::of(scene);
    let atlas = atlas.map(|name| Named { what: "atlas", name, max_bytes: MAX_ATLAS_BYTES });
    let model = |name| Named { what: "model", name, max_bytes: model_glb::MAX_BYTES };
    atlas.into_iter().chain(models.into_iter().map(model)).filter(|named| is_beside(&named.name)).collect()
}

/// The names of all models that `scene` has of its own.
pub(crate) fn models_of(scene: &Scene) -> BTreeSet<String> {
    Names::of(scene).models
}

impl Names {
    fn of(scene: &Scene) -> Self {
        let flying = scene.aircraft.iter().filter_map(|aircraft| aircraft.model.clone());
        let models = flying.chain(scene.props.iter().map(|prop| prop.model.clone()));
        Self { atlas: scene.atlas.clone(), models: models.collect() }
    }
}

/// Where the model of that name is asked for first, and what helps if it is none.
fn asker(name: &str, scene: &Scene) -> (String, &'static str) {
    match scene.aircraft.iter().position(|one| one.model.as_deref() == Some(name)) {
        Some(index) => (format!("aircraft[{index}].model"), "take `model` out for the built-in aircraft"),
        None => {
            let index = scene.props.iter().position(|one| one.model == name).unwrap_or_default();
            (format!("props[{index}].model"), "name another file, or take the prop out")
        }
    }
}

/// What is wrong, and a hint.
type Trouble = (String, &'static str);

fn atlas(name: &str, scene_path: Option<&Path>) -> Result<Atlas, Trouble> {
    let hint = "an atlas is a PNG of 512 × 512 pixels with alpha; take `atlas` out for the built-in one";
    Atlas::from_png(&file(name, scene_path, MAX_ATLAS_BYTES)?).map_err(|error| (error.to_string(), hint))
}

fn file(name: &str, scene_path: Option<&Path>, max_bytes: usize) -> Result<Vec<u8>, Trouble> {
    if !is_beside(name) {
        return Err(("it doesn't lie beside the scene file".into(), "copy it there, and give its name alone"));
    }
    let Some(scene_path) = scene_path else {
        return Err(("the scene has no folder yet".into(), "save the scene beside it"));
    };
    storage::read(&scene_path.with_file_name(name), max_bytes).map_err(|error| {
        (
            format!("can't be read: {}", error.reason()),
            "put it beside the scene file, or take its name out of the scene",
        )
    })
}

/// A scene from elsewhere has no business with files in other folders.
fn is_beside(name: &str) -> bool {
    !name.is_empty() && Path::new(name).components().all(|part| matches!(part, Component::Normal(_)))
}
