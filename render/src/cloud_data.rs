//! The scene's clouds on the GPU.
//!
//! On the edit clock: sprites, groups and clouds, in data textures. When the clouds' version is another, what differs
//! from what the textures hold is written: a renamed or moved cloud sends nothing, a recoloured one its own texels, one
//! with more sprites or fewer its own and those of all behind it.
//! On the camera clock: which sprites to draw in what order, the poses of those near the eye, and of each cloud how the
//! moment has it ([`CloudNow`]) and where it lies from the eye; that difference is taken in f64 here, so that a scene 1,000 km from the
//! origin is as sharp as one at it.
//! What lies there are texels ([`crate::texels`]).

use crate::buffer::VertexBuffer;
use crate::texels::{
    BakedTexels, CloudTexels, GroupTexels, MomentTexels, PoseTexels, SpriteTexels, StirTexel, baked_texels,
    cloud_texels, group_texels, moment_texels, pose_texels, sprite_texels,
};
use crate::texture::DataTexture;
use crate::{Gpu, RenderError};
use cloudwright_core::baked::WORDS;
use cloudwright_core::draw_list::DrawList;
use cloudwright_core::facing::Pose;
use cloudwright_core::frame::Frame;
use cloudwright_core::sprites::{Group, PlacedCloud, Sprites};
use cloudwright_core::version::Version;
use cloudwright_core::weather::CloudNow;
use std::sync::Arc;

/// What the vertex shader is given of a sprite: cloud index, sprite address, and pose, if it has one of its own.
pub(crate) type Instance = [u32; 3];

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
    /// What other clouds take of the light, a node a texel.
    pub(crate) shades: DataTexture,
    held_shades: Vec<[f32; 4]>,
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
            shades: DataTexture::new(gpu, "shade on clouds"),
            held_shades: Vec::new(),
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
        let mut moments: Vec<MomentTexels> =
            frame.now.clouds.iter().map(|cloud| moment_texels(cloud, &frame.view, &frame.now.light)).collect();
        renewed |= self.write_shades(gpu, &frame.now.clouds, &mut moments)?;
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
            (first_sprite, first_group) = (first_sprite + sprites.all().len(), first_group + groups.len());
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
            (now.first_sprite, is_known, now.sprites.all().iter().map(move |sprite| sprite_texels(sprite, first_group)))
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

    /// What other clouds take of the light on each, if that is not what it was; tells `moments` where.
    fn write_shades(
        &mut self,
        gpu: &Gpu,
        clouds: &[CloudNow<'_>],
        moments: &mut [MomentTexels],
    ) -> Result<bool, RenderError> {
        let mut nodes: Vec<[f32; 4]> = Vec::new();
        for (cloud, moment) in clouds.iter().zip(moments) {
            let Some(shade) = &cloud.shade else { continue };
            let [columns, rows] = shade.size;
            moment.shade_low = shade.low.to_array();
            moment.shade_nodes_a_metre = shade.nodes_a_metre.to_array();
            moment.shade_first_and_size = ((nodes.len() as u32) << 10) | (rows << 5) | columns;
            nodes.extend(shade.nodes.iter().map(|[depth, stands, half]| [*depth, *stands, *half, 0.0]));
        }
        if nodes.is_empty() || nodes == self.held_shades {
            return Ok(false);
        }
        let is_new = self.shades.write(gpu, &nodes)?;
        self.bytes_uploaded += size_of_val(nodes.as_slice()) as u64;
        self.held_shades = nodes;
        Ok(is_new)
    }

    /// The sprites of the cloud of that index, as the shadows pass reads them.
    pub(crate) fn casters_of(&self, index: usize, cloud: &CloudNow<'_>) -> Vec<Instance> {
        let Some(first) = self.uploaded.get(index).map(|uploaded| uploaded.first_sprite) else { return Vec::new() };
        let depths = cloud.placed.casts().depths.iter().zip(first..);
        depths.map(|(depth, sprite)| [index as u32, sprite as u32, depth.to_bits()]).collect()
    }

    /// What the air makes of the sprites of clouds of which it is not known yet.
    fn write_stirs(&mut self, gpu: &Gpu, clouds: &[PlacedCloud]) -> Result<bool, RenderError> {
        if self.uploaded.iter().all(|cloud| cloud.has_stirs) {
            return Ok(false);
        }
        let count = self.uploaded.last().map_or(0, |last| last.first_sprite + last.sprites.all().len());
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
                if sprite >= cloud.sprites.all().len() {
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
