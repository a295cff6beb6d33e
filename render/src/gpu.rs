//! An adapter's device and queue: headless, or a window's own.
//!
//! Asks for no more than OpenGL ES 3.0 has (WebGL 2's limits: no compute, no storage buffers) but for the sizes of
//! textures and buffers, so that software rasterizers and old machines draw too. Timestamps are taken where they are
//! offered. Losing the device is an event ([`Gpu::check`]), never a panic.

use crate::fault::Faults;
use crate::{GpuError, RenderError};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Which adapter to draw with.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub enum AdapterChoice {
    /// The best there is: hardware, then software by Vulkan, then software by OpenGL.
    #[default]
    Any,
    /// As `Any`, but never software.
    HardwareOnly,
    /// The best on one backend.
    On(wgpu::Backend),
    /// The best whose [`Gpu::label`] contains this, in any case.
    Named(String),
}

/// A device to draw with.
#[derive(Debug, Clone)]
pub struct Gpu {
    device: wgpu::Device,
    queue: wgpu::Queue,
    info: wgpu::AdapterInfo,
    faults: Arc<Faults>,
}

/// How long a frame may take before the device is given up. A software rasterizer may need many seconds.
const PATIENCE: Duration = Duration::from_secs(180);
/// One wait. Short, because Mesa's OpenGL gives up a long one half-way and says so with an error.
const ONE_WAIT: Duration = Duration::from_secs(1);

impl Gpu {
    /// A device without a window.
    ///
    /// # Errors
    /// If no adapter fits the choice, or it gives no device.
    pub fn headless(choice: &AdapterChoice) -> Result<Self, GpuError> {
        let mut adapters = all_adapters();
        adapters.sort_by_key(|adapter| rank(&adapter.get_info()));
        let Some(adapter) = adapters.iter().find(|adapter| choice.allows(&adapter.get_info())) else {
            return Err(GpuError::NoAdapter { wanted: choice.to_string(), found: found(&adapters) });
        };
        let no_device = |source| GpuError::NoDevice { adapter: label(&adapter.get_info()), source };
        let descriptor = Self::device_descriptor(adapter);
        let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).map_err(no_device)?;
        fit(adapter)?;
        Ok(Self::from_parts(device, queue, adapter.get_info()))
    }

    /// Draws with a window's own device. It should have been asked for with [`Gpu::device_descriptor`]; its handlers
    /// for lost devices and uncaptured errors are replaced.
    pub fn from_parts(device: wgpu::Device, queue: wgpu::Queue, info: wgpu::AdapterInfo) -> Self {
        let faults = Faults::of(&device);
        Self { device, queue, info, faults }
    }

    /// What a device must be able to do to draw frames, for a window that asks for its own.
    pub fn device_descriptor(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
        let limits = adapter.limits();
        wgpu::DeviceDescriptor {
            label: Some("cloudwright"),
            required_features: adapter.features() & wgpu::Features::TIMESTAMP_QUERY,
            required_limits: wgpu::Limits {
                max_buffer_size: limits.max_buffer_size,
                ..wgpu::Limits::downlevel_webgl2_defaults().using_resolution(limits)
            },
            ..Default::default()
        }
    }

    /// The adapters of this machine, best first, software included.
    pub fn adapters() -> Vec<wgpu::AdapterInfo> {
        let mut infos: Vec<_> = all_adapters().iter().map(wgpu::Adapter::get_info).collect();
        infos.sort_by_key(rank);
        infos
    }

    /// wgpu's device.
    pub fn device(&self) -> &wgpu::Device {
        &self.device
    }

    /// Its queue.
    pub fn queue(&self) -> &wgpu::Queue {
        &self.queue
    }

    /// What the driver says of itself.
    pub fn info(&self) -> &wgpu::AdapterInfo {
        &self.info
    }

    /// Name and backend, for people.
    pub fn label(&self) -> String {
        label(&self.info)
    }

    /// Whether the “GPU” is a program on the CPU.
    pub fn is_software(&self) -> bool {
        is_software(&self.info)
    }

    /// What the device reported since the last look.
    ///
    /// # Errors
    /// [`RenderError::DeviceLost`] from then on, [`RenderError::Refused`] once.
    pub fn check(&self) -> Result<(), RenderError> {
        // wgpu tells of a loss when it is polled.
        self.poll(wgpu::PollType::Poll)?;
        self.faults.check()
    }

    /// Waits for all that was submitted, and until `done` says so.
    pub(crate) fn wait_until(&self, mut done: impl FnMut() -> bool) -> Result<(), RenderError> {
        let start = Instant::now();
        while start.elapsed() < PATIENCE {
            let all_done = self.poll(wgpu::PollType::Wait { submission_index: None, timeout: Some(ONE_WAIT) })?;
            self.faults.check()?;
            if all_done && done() {
                return Ok(());
            }
        }
        Err(RenderError::TimedOut(PATIENCE.as_secs()))
    }

    /// False if a wait was in vain. wgpu panics where it polls a device that is gone; to us that is an event.
    fn poll(&self, how: wgpu::PollType) -> Result<bool, RenderError> {
        match catch_unwind(AssertUnwindSafe(|| self.device.poll(how))) {
            Ok(Ok(_)) => Ok(true),
            Ok(Err(wgpu::PollError::Timeout)) => Ok(false),
            Ok(Err(error)) => Err(RenderError::Refused(error.to_string())),
            Err(_) => {
                self.faults.note_loss("it does not answer");
                self.faults.check().map(|()| false)
            }
        }
    }
}

impl AdapterChoice {
    fn allows(&self, info: &wgpu::AdapterInfo) -> bool {
        match self {
            Self::Any => true,
            Self::HardwareOnly => !is_software(info),
            Self::On(backend) => info.backend == *backend,
            Self::Named(part) => label(info).to_lowercase().contains(&part.to_lowercase()),
        }
    }
}

impl std::fmt::Display for AdapterChoice {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Any => f.write_str("was found"),
            Self::HardwareOnly => f.write_str("of real hardware was found"),
            Self::On(backend) => write!(f, "was found for {backend:?}"),
            Self::Named(part) => write!(f, "is named “{part}”"),
        }
    }
}

fn all_adapters() -> Vec<wgpu::Adapter> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()))
}

/// Best first: hardware before software, strong before weak, OpenGL last among its like.
fn rank(info: &wgpu::AdapterInfo) -> (bool, u8, bool) {
    let weakness = match info.device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other | wgpu::DeviceType::Cpu => 3,
    };
    let software = is_software(info);
    // OpenGL does not say what it runs on: judge it after all else of its like.
    (software, if software { 0 } else { weakness }, info.backend == wgpu::Backend::Gl)
}

fn is_software(info: &wgpu::AdapterInfo) -> bool {
    let name = info.name.to_lowercase();
    info.device_type == wgpu::DeviceType::Cpu
        || ["llvmpipe", "lavapipe", "swiftshader", "softpipe"].iter().any(|part| name.contains(part))
}

fn label(info: &wgpu::AdapterInfo) -> String {
    format!("{}, {:?}", info.name, info.backend)
}

fn found(adapters: &[wgpu::Adapter]) -> String {
    if adapters.is_empty() {
        return "this machine shows none at all".into();
    }
    let labels: Vec<_> = adapters.iter().map(|adapter| label(&adapter.get_info())).collect();
    format!("this machine has {}", labels.join("; "))
}

/// Blending into 16-bit floats is optional in OpenGL ES 3.0.
fn fit(adapter: &wgpu::Adapter) -> Result<(), GpuError> {
    let features = adapter.get_texture_format_features(crate::texture::LINEAR_FORMAT);
    let can = features.allowed_usages.contains(wgpu::TextureUsages::RENDER_ATTACHMENT)
        && features.flags.contains(wgpu::TextureFormatFeatureFlags::BLENDABLE);
    if can {
        return Ok(());
    }
    Err(GpuError::Unfit { adapter: label(&adapter.get_info()), missing: "blend into 16-bit floats" })
}
