//! The scene's clouds on the GPU.
//!
//! On the edit clock: sprites, groups and clouds, in data textures. When the clouds' version is another, what differs
//! from what the textures hold is written: a renamed or moved cloud sends nothing, a recoloured one its own texels, one
//! with more sprites or fewer its own and those of all behind it.
//! On the camera clock: which sprites to draw in what order, the poses of those near the eye, and of each cloud how the
//! moment has it ([`CloudNow`]) and where it lies from the eye; that difference is taken in f64 here, so that a scene 1,000 km from the
//! origin is as sharp as one at it.
//! The structs are texels of four words; sprites.wgsl reads them.

use crate::buffer::VertexBuffer;
use crate::texture::DataTexture;
use crate::{Gpu, RenderError};
use cloudwright_core::baked::{Around, DIRECTIONS, WORDS};
use cloudwright_core::camera::View;
use cloudwright_core::draw_list::DrawList;
use cloudwright_core::facing::Pose;
use cloudwright_core::frame::Frame;
use cloudwright_core::sprites::{Group, PlacedCloud, Sprite, Sprites};
use cloudwright_core::version::Version;
use cloudwright_core::weather::{CloudNow, Light};
use std::sync::Arc;

/// What the vertex shader is given of a sprite: cloud index, sprite address, and pose, if it has one of its own.
pub(crate) type Instance = [u32; 3];

#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct SpriteTexels {
    position: [f32; 3],
    width: f32,
    height: f32,
    sin_rotation: f32,
    cos_rotation: f32,
    /// Address of its group, times 16, plus its tile.
    group_and_tile: u32,
}

#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct GroupTexels {
    center: [f32; 3],
    c: [f32; 3],
    unused: [f32; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct CloudTexels {
    center: [f32; 3],
    /// 0 for a cloud without extent.
    inverse_radius: f32,
    bottom: f32,
    top: f32,
    level_height_4: f32,
    /// Where what is baked of its sprites begins, counted from where its sprites do; wraps.
    baked_from_sprites: u32,
    level_heights_0_to_3: [f32; 4],
    level_colors: [[f32; 4]; 5],
}

/// A cloud in one frame.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct MomentTexels {
    from_eye: [f32; 3],
    formed_core: f32,
    formed_falloff: f32,
    growth: f32,
    opacity: f32,
    scale: f32,
    /// Sine and cosine.
    turn: [f32; 2],
    /// Negative in air that carries nothing.
    reach_m: f32,
    /// Of the sun's light.
    self_shadow: f32,
    /// The directions around the light's, a byte each, and their shares.
    around: u32,
    shares: [f32; 3],
    /// Sine and cosine of the turn from the model's space.
    heading: [f32; 2],
    halo: f32,
    unused: f32,
}

/// What the air makes of a sprite, as [`Stir::packed`].
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(transparent)]
pub(crate) struct StirTexel([u32; 4]);

/// The light that is baked of a sprite: its words, and two that are not used.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(transparent)]
pub(crate) struct BakedTexels([u32; 16]);

/// A sprite near the eye, in one frame.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct PoseTexels {
    towards: [f32; 3],
    fade: f32,
    up: [f32; 3],
    unused: f32,
}

/// A cloud as the textures hold it. Sprites and groups are told apart by where they are kept.
#[derive(Debug)]
struct Uploaded {
    sprites: Sprites,
    groups: Arc<[Group]>,
    cloud: CloudTexels,
    first_sprite: usize,
    first_group: usize,
    /// Whether what the air makes of its sprites has been written.
    has_stirs: bool,
}

/// What is baked of a model, as the textures hold it: of which its words are, and where they begin.
#[derive(Debug)]
struct UploadedBaked {
    words: Arc<[u32]>,
    first: usize,
}

/// All that the sprites pass reads but the atlas.
#[derive(Debug)]
pub(crate) struct CloudData {
    pub(crate) sprites: DataTexture,
    pub(crate) groups: DataTexture,
    pub(crate) clouds: DataTexture,
    pub(crate) moments: DataTexture,
    pub(crate) poses: DataTexture,
    /// Empty until there is weather.
    pub(crate) stirs: DataTexture,
    /// Empty until a cloud is lit by it.
    pub(crate) baked: DataTexture,
    /// Cloud index, sprite address and pose of each sprite to draw, back to front.
    pub(crate) order: VertexBuffer,
    /// The same in the order that fades out.
    pub(crate) older_order: VertexBuffer,
    /// What sprites, groups and clouds hold, and of which version that is; nothing after an error.
    uploaded: Vec<Uploaded>,
    uploaded_baked: Vec<UploadedBaked>,
    version: Option<Version>,
    /// Whether colours or light of any cloud were those of a moment.
    looks: bool,
    /// By the last update.
    pub(crate) bytes_uploaded: u64,
}

impl CloudData {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        Self {
            sprites: DataTexture::new(gpu, "sprites"),
            groups: DataTexture::new(gpu, "shading groups"),
            clouds: DataTexture::new(gpu, "clouds"),
            moments: DataTexture::new(gpu, "clouds in this frame"),
            poses: DataTexture::new(gpu, "poses"),
            stirs: DataTexture::new(gpu, "what the air makes of sprites"),
            baked: DataTexture::new(gpu, "light at sprites"),
            order: VertexBuffer::new(gpu, "the list of sprites in view"),
            older_order: VertexBuffer::new(gpu, "the list of sprites in view"),
            uploaded: Vec::new(),
            uploaded_baked: Vec::new(),
            version: None,
            looks: false,
            bytes_uploaded: 0,
        }
    }

    /// Brings everything up to date with `frame`. True if a texture is a new one.
    ///
    /// # Errors
    /// If the device can't hold so many sprites.
    pub(crate) fn update(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<bool, RenderError> {
        let mut renewed = false;
        self.bytes_uploaded = 0;
        let looks = frame.now.clouds.iter().any(|cloud| cloud.look.is_some());
        let baked = self.write_baked(gpu, &frame.now.clouds)?;
        renewed |= baked == Some(true);
        if self.version != Some(frame.clouds_version) || looks || self.looks || baked.is_some() {
            self.version = None;
            renewed |= self.write_clouds(gpu, &frame.now.clouds)?;
            (self.version, self.looks) = (Some(frame.clouds_version), looks);
        }
        if frame.now.air().is_some() {
            renewed |= self.write_stirs(gpu, frame.clouds)?;
        }
        let moments: Vec<MomentTexels> =
            frame.now.clouds.iter().map(|cloud| moment_texels(cloud, &frame.view, &frame.now.light)).collect();
        let mut poses: Vec<PoseTexels> = frame.list.poses.iter().map(pose_texels).collect();
        // Both orders show the same poses.
        let order = self.in_order(frame, &frame.list, &mut poses);
        let older = frame.fading.as_ref().map(|(older, _)| self.in_order(frame, older, &mut poses));
        renewed |= self.moments.write(gpu, &moments)? | self.poses.write(gpu, &poses)?;
        self.bytes_uploaded += (size_of_val(moments.as_slice()) + size_of_val(poses.as_slice())) as u64;
        self.order.write(gpu, &order)?;
        if let Some(older) = older {
            self.older_order.write(gpu, &older)?;
            self.bytes_uploaded += self.older_order.bytes();
        }
        self.bytes_uploaded += self.order.bytes();
        Ok(renewed)
    }

    fn write_clouds(&mut self, gpu: &Gpu, clouds: &[CloudNow<'_>]) -> Result<bool, RenderError> {
        let before = std::mem::take(&mut self.uploaded);
        let (mut first_sprite, mut first_group) = (0, 0);
        let uploaded = clouds.iter().map(|cloud| {
            let (sprites, groups) = (cloud.placed.sprites.clone(), Arc::clone(cloud.groups()));
            let firsts = (first_sprite, first_group);
            (first_sprite, first_group) = (first_sprite + sprites.len(), first_group + groups.len());
            let (first_sprite, first_group) = firsts;
            let first_baked = self.first_baked(cloud).map_or(0, |first| first.wrapping_sub(first_sprite as u32));
            let cloud = cloud_texels(cloud, first_baked);
            Uploaded { sprites, groups, cloud, first_sprite, first_group, has_stirs: false }
        });
        let mut after: Vec<Uploaded> = uploaded.collect();
        let new_sprites = self.sprites.reserve::<SpriteTexels>(gpu, first_sprite)?;
        let new_groups = self.groups.reserve::<GroupTexels>(gpu, first_group)?;
        let new_clouds = self.clouds.reserve::<CloudTexels>(gpu, after.len())?;
        // What is at the same place as before, in a texture that is still the same.
        let known = |index: usize, is_new: bool| before.get(index).filter(|_| !is_new);
        let each = || after.iter().enumerate();
        let sprites = each().map(|(index, now)| {
            let is_known = known(index, new_sprites).is_some_and(|old| {
                old.sprites.are(&now.sprites)
                    && (old.first_sprite, old.first_group) == (now.first_sprite, now.first_group)
            });
            let first_group = now.first_group as u32;
            (now.first_sprite, is_known, now.sprites.iter().map(move |sprite| sprite_texels(sprite, first_group)))
        });
        let groups = each().map(|(index, now)| {
            let is_known = known(index, new_groups)
                .is_some_and(|old| Arc::ptr_eq(&old.groups, &now.groups) && old.first_group == now.first_group);
            (now.first_group, is_known, now.groups.iter().map(group_texels))
        });
        let clouds = each().map(|(index, now)| {
            let is_known = known(index, new_clouds).is_some_and(|old| old.cloud == now.cloud);
            (index, is_known, std::iter::once(now.cloud))
        });
        self.bytes_uploaded += write_unknown(gpu, &self.sprites, sprites)
            + write_unknown(gpu, &self.groups, groups)
            + write_unknown(gpu, &self.clouds, clouds);
        for (old, now) in before.iter().zip(&mut after) {
            let same_place = old.sprites.are(&now.sprites) && old.first_sprite == now.first_sprite;
            now.has_stirs = old.has_stirs && same_place;
        }
        self.uploaded = after;
        Ok(new_sprites | new_groups | new_clouds)
    }

    /// The light at the sprites of the models that have it, each once. None if all stands as it did; else whether the texture
    /// is a new one.
    fn write_baked(&mut self, gpu: &Gpu, clouds: &[CloudNow<'_>]) -> Result<Option<bool>, RenderError> {
        let mut after: Vec<UploadedBaked> = Vec::new();
        let mut first = 0;
        for words in clouds.iter().filter_map(|cloud| Some(cloud.baked?.words())) {
            // Placements of a model mostly follow one another.
            if !after.iter().rev().any(|known| Arc::ptr_eq(&known.words, words)) {
                after.push(UploadedBaked { words: Arc::clone(words), first });
                first += words.len() / WORDS;
            }
        }
        let same = |(old, now): (&UploadedBaked, &UploadedBaked)| Arc::ptr_eq(&old.words, &now.words);
        if after.len() == self.uploaded_baked.len() && self.uploaded_baked.iter().zip(&after).all(same) {
            return Ok(None);
        }
        let before = std::mem::take(&mut self.uploaded_baked);
        let is_new = self.baked.reserve::<BakedTexels>(gpu, first)?;
        let parts = after.iter().enumerate().map(|(index, now)| {
            let old = before.get(index).filter(|old| !is_new && old.first == now.first);
            let is_known = old.is_some_and(|old| Arc::ptr_eq(&old.words, &now.words));
            (now.first, is_known, now.words.chunks_exact(WORDS).map(baked_texels))
        });
        self.bytes_uploaded += write_unknown(gpu, &self.baked, parts);
        self.uploaded_baked = after;
        Ok(Some(is_new))
    }

    /// Where what is baked of a cloud's model begins, if anything is.
    fn first_baked(&self, cloud: &CloudNow<'_>) -> Option<u32> {
        let words = cloud.baked?.words();
        Some(self.uploaded_baked.iter().find(|known| Arc::ptr_eq(&known.words, words))?.first as u32)
    }

    /// What the air makes of the sprites of clouds of which it is not known yet.
    fn write_stirs(&mut self, gpu: &Gpu, clouds: &[PlacedCloud]) -> Result<bool, RenderError> {
        if self.uploaded.iter().all(|cloud| cloud.has_stirs) {
            return Ok(false);
        }
        let count = self.uploaded.last().map_or(0, |last| last.first_sprite + last.sprites.len());
        let is_new = self.stirs.reserve::<StirTexel>(gpu, count)?;
        let texels =
            |cloud: &'_ PlacedCloud| cloud.stirs().iter().map(|stir| StirTexel(stir.packed())).collect::<Vec<_>>();
        let parts = self.uploaded.iter().zip(clouds).map(|(uploaded, cloud)| {
            let is_known = uploaded.has_stirs && !is_new;
            (uploaded.first_sprite, is_known, if is_known { Vec::new() } else { texels(cloud) }.into_iter())
        });
        self.bytes_uploaded += write_unknown(gpu, &self.stirs, parts);
        self.uploaded.iter_mut().for_each(|cloud| cloud.has_stirs = true);
        Ok(is_new)
    }

    /// The list's sprites. Those that their run fades have poses of their own, which are added to `poses`.
    fn in_order(&self, frame: &Frame<'_>, list: &DrawList, poses: &mut Vec<PoseTexels>) -> Vec<Instance> {
        let mut instances = Vec::with_capacity(list.sprites.len());
        for (sprites, fade) in list.sprite_runs() {
            for drawn in sprites {
                // A list of other clouds than the frame's would be a fault of the caller's; it draws what there is.
                let Some(cloud) = self.uploaded.get(drawn.cloud as usize) else { continue };
                let sprite = drawn.sprite as usize;
                if sprite >= cloud.sprites.len() {
                    continue;
                }
                let mut pose = drawn.pose;
                if fade < 1.0 {
                    let whole = list.pose(drawn, &frame.view);
                    pose = poses.len() as u32;
                    poses.push(pose_texels(&Pose { fade: whole.fade * fade, ..whole }));
                }
                instances.push([drawn.cloud, (cloud.first_sprite + sprite) as u32, pose]);
            }
        }
        instances
    }
}

/// Writes those parts of `table` that it does not hold yet, neighbours at once: where each begins, whether it is known,
/// and its elements. How many bytes that were.
fn write_unknown<T: bytemuck::Pod, I: Iterator<Item = T>>(
    gpu: &Gpu,
    table: &DataTexture,
    parts: impl Iterator<Item = (usize, bool, I)>,
) -> u64 {
    let (mut run, mut begins_at, mut bytes) = (Vec::new(), 0, 0);
    let mut write = |begins_at: usize, run: &mut Vec<T>| {
        table.write_at(gpu, begins_at, run);
        bytes += size_of_val(run.as_slice()) as u64;
        run.clear();
    };
    for (first, is_known, elements) in parts {
        if is_known {
            write(begins_at, &mut run);
        } else {
            if run.is_empty() {
                begins_at = first;
            }
            run.extend(elements);
        }
    }
    write(begins_at, &mut run);
    bytes
}

fn sprite_texels(sprite: &Sprite, first_group: u32) -> SpriteTexels {
    let (sin_rotation, cos_rotation) = libm::sincosf(sprite.rotation);
    SpriteTexels {
        position: sprite.position.to_array(),
        width: sprite.width,
        height: sprite.height,
        sin_rotation,
        cos_rotation,
        group_and_tile: ((first_group + sprite.group) << 4) | u32::from(sprite.tile & 15),
    }
}

fn group_texels(group: &Group) -> GroupTexels {
    GroupTexels { center: group.center.to_array(), c: group.c, unused: [0.0; 2] }
}

fn baked_texels(words: &[u32]) -> BakedTexels {
    BakedTexels(std::array::from_fn(|word| words.get(word).copied().unwrap_or_default()))
}

fn cloud_texels(cloud: &CloudNow<'_>, baked_from_sprites: u32) -> CloudTexels {
    let (levels, cloud) = (cloud.color_levels(), cloud.placed);
    let heights = levels.map(|level| level.height as f32);
    let [h0, h1, h2, h3, level_height_4] = heights;
    CloudTexels {
        center: cloud.center.to_array(),
        inverse_radius: if cloud.radius > 0.0 { 1.0 / cloud.radius } else { 0.0 },
        bottom: cloud.bottom,
        top: cloud.top,
        level_height_4,
        baked_from_sprites,
        level_heights_0_to_3: [h0, h1, h2, h3],
        level_colors: levels.map(|level| level.color.to_array()),
    }
}

fn moment_texels(cloud: &CloudNow<'_>, view: &View, light: &Light) -> MomentTexels {
    let Around { at: [a, b, c], share } = DIRECTIONS.around(cloud.in_model(cloud.direction_at_rest(light.direction)));
    let soft_light = cloud.placed.soft_light;
    let as_baked = |share: f32| if cloud.baked.is_some() { share } else { 0.0 };
    MomentTexels {
        from_eye: cloud.from_eye(view.eye).to_array(),
        formed_core: cloud.formed.core,
        formed_falloff: cloud.formed.falloff,
        growth: cloud.growth,
        opacity: cloud.opacity,
        scale: cloud.scale,
        turn: cloud.turn.sin_cos(),
        reach_m: cloud.air.as_ref().map_or(-1.0, |air| air.reach_m),
        self_shadow: as_baked(soft_light.self_shadow),
        around: a | (b << 8) | (c << 16),
        shares: share,
        heading: cloud.placed.heading,
        halo: as_baked(soft_light.halo),
        unused: 0.0,
    }
}

fn pose_texels(pose: &Pose) -> PoseTexels {
    PoseTexels { towards: pose.towards.to_array(), fade: pose.fade, up: pose.up.to_array(), unused: 0.0 }
}
