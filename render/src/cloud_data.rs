//! The scene's clouds on the GPU.
//!
//! On the edit clock: sprites, groups and clouds, in data textures, written when the clouds' version is another.
//! On the camera clock: which sprites to draw in what order, the poses of those near the eye, and of each cloud how the
//! moment has it ([`CloudNow`]) and where it lies from the eye; that difference is taken in f64 here, so that a scene 1,000 km from the
//! origin is as sharp as one at it.
//! The structs are texels of four words; sprites.wgsl reads them.

use crate::buffer::VertexBuffer;
use crate::texture::DataTexture;
use crate::{Gpu, RenderError};
use cloudwright_core::camera::View;
use cloudwright_core::draw_list::DrawList;
use cloudwright_core::facing::Pose;
use cloudwright_core::frame::Frame;
use cloudwright_core::sprites::{Group, PlacedCloud, Sprite};
use cloudwright_core::version::Version;
use cloudwright_core::weather::CloudNow;

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

#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct CloudTexels {
    center: [f32; 3],
    /// 0 for a cloud without extent.
    inverse_radius: f32,
    bottom: f32,
    top: f32,
    level_height_4: f32,
    unused: f32,
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
    unused: f32,
}

/// A sprite near the eye, in one frame.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct PoseTexels {
    towards: [f32; 3],
    fade: f32,
    up: [f32; 3],
    unused: f32,
}

/// All that the sprites pass reads but the atlas.
#[derive(Debug)]
pub(crate) struct CloudData {
    pub(crate) sprites: DataTexture,
    pub(crate) groups: DataTexture,
    pub(crate) clouds: DataTexture,
    pub(crate) moments: DataTexture,
    pub(crate) poses: DataTexture,
    /// Cloud index, sprite address and pose of each sprite to draw, back to front.
    pub(crate) order: VertexBuffer,
    /// The same in the order that fades out.
    pub(crate) older_order: VertexBuffer,
    /// Each cloud's first sprite and how many it has.
    sprites_of_cloud: Vec<(u32, u32)>,
    uploaded: Option<Version>,
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
            order: VertexBuffer::new(gpu, "the list of sprites in view"),
            older_order: VertexBuffer::new(gpu, "the list of sprites in view"),
            sprites_of_cloud: Vec::new(),
            uploaded: None,
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
        if self.uploaded != Some(frame.clouds_version) {
            self.uploaded = None;
            renewed |= self.write_clouds(gpu, frame.clouds)?;
            self.uploaded = Some(frame.clouds_version);
        }
        let moments: Vec<MomentTexels> =
            frame.now.clouds.iter().map(|cloud| moment_texels(cloud, &frame.view)).collect();
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

    fn write_clouds(&mut self, gpu: &Gpu, clouds: &[PlacedCloud]) -> Result<bool, RenderError> {
        let (mut sprites, mut groups) = (Vec::new(), Vec::new());
        self.sprites_of_cloud.clear();
        for cloud in clouds {
            let first_group = groups.len() as u32;
            self.sprites_of_cloud.push((sprites.len() as u32, cloud.sprites.len() as u32));
            sprites.extend(cloud.sprites.iter().map(|sprite| sprite_texels(sprite, first_group)));
            groups.extend(cloud.groups.iter().map(group_texels));
        }
        let clouds: Vec<CloudTexels> = clouds.iter().map(cloud_texels).collect();
        self.bytes_uploaded +=
            (size_of_val(sprites.as_slice()) + size_of_val(groups.as_slice()) + size_of_val(clouds.as_slice())) as u64;
        Ok(self.sprites.write(gpu, &sprites)? | self.groups.write(gpu, &groups)? | self.clouds.write(gpu, &clouds)?)
    }

    /// The list's sprites. Those that their run fades have poses of their own, which are added to `poses`.
    fn in_order(&self, frame: &Frame<'_>, list: &DrawList, poses: &mut Vec<PoseTexels>) -> Vec<Instance> {
        let mut instances = Vec::with_capacity(list.sprites.len());
        for (sprites, fade) in list.sprite_runs() {
            for drawn in sprites {
                // A list of other clouds than the frame's would be a fault of the caller's; it draws what there is.
                let Some((first, count)) = self.sprites_of_cloud.get(drawn.cloud as usize).copied() else { continue };
                if drawn.sprite >= count {
                    continue;
                }
                let mut pose = drawn.pose;
                if fade < 1.0 {
                    let whole = list.pose(drawn, &frame.view);
                    pose = poses.len() as u32;
                    poses.push(pose_texels(&Pose { fade: whole.fade * fade, ..whole }));
                }
                instances.push([drawn.cloud, first + drawn.sprite, pose]);
            }
        }
        instances
    }
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

fn cloud_texels(cloud: &PlacedCloud) -> CloudTexels {
    let heights = cloud.color_levels.map(|level| level.height as f32);
    let [h0, h1, h2, h3, level_height_4] = heights;
    CloudTexels {
        center: cloud.center.to_array(),
        inverse_radius: if cloud.radius > 0.0 { 1.0 / cloud.radius } else { 0.0 },
        bottom: cloud.bottom,
        top: cloud.top,
        level_height_4,
        unused: 0.0,
        level_heights_0_to_3: [h0, h1, h2, h3],
        level_colors: cloud.color_levels.map(|level| level.color.to_array()),
    }
}

fn moment_texels(cloud: &CloudNow<'_>, view: &View) -> MomentTexels {
    MomentTexels {
        from_eye: cloud.from_eye(view.eye).to_array(),
        formed_core: cloud.formed.core,
        formed_falloff: cloud.formed.falloff,
        growth: cloud.growth,
        opacity: cloud.opacity,
        unused: 0.0,
    }
}

fn pose_texels(pose: &Pose) -> PoseTexels {
    PoseTexels { towards: pose.towards.to_array(), fade: pose.fade, up: pose.up.to_array(), unused: 0.0 }
}
