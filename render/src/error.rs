//! What can go wrong with a GPU, said so that the reader knows what to do next.

/// Why there is no GPU to draw with.
#[derive(Debug, thiserror::Error)]
pub enum GpuError {
    /// No adapter is as asked for.
    #[error(
        "no graphics adapter {wanted}; {found}. Install a driver for Vulkan or OpenGL (on Linux without a GPU: \
         mesa-vulkan-drivers), or draw on the CPU"
    )]
    NoAdapter {
        /// What was asked for.
        wanted: String,
        /// What there is.
        found: String,
    },
    /// The adapter gives no device.
    #[error("the graphics adapter {adapter} refuses to work: {source}. Update its driver, or choose another adapter")]
    NoDevice {
        /// Name and backend.
        adapter: String,
        /// wgpu's reason.
        source: wgpu::RequestDeviceError,
    },
    /// The adapter lacks something that every frame needs.
    #[error("the graphics adapter {adapter} cannot {missing}; choose another adapter, or draw on the CPU")]
    Unfit {
        /// Name and backend.
        adapter: String,
        /// What it lacks.
        missing: &'static str,
    },
}

/// Why a frame was not drawn.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum RenderError {
    /// The device is gone: a driver's reset, an unplugged adapter. Make a new [`crate::Gpu`] and a new renderer.
    #[error("the graphics device was lost ({0}); start it again, or draw on the CPU")]
    DeviceLost(String),
    /// The driver ran out of memory or refused a command.
    #[error("the graphics driver refused to draw: {0}")]
    Refused(String),
    /// More than the device can hold.
    #[error("{what} needs {wanted}, but this graphics device's limit {limit_name} is {limit}; {remedy}")]
    TooLarge {
        /// What does not fit.
        what: &'static str,
        /// How much it needs.
        wanted: u64,
        /// wgpu's name of the limit.
        limit_name: &'static str,
        /// The limit.
        limit: u64,
        /// What to do.
        remedy: &'static str,
    },
    /// No answer for too long.
    #[error("the graphics device gave no answer for {0} seconds; make the picture smaller, or draw on the CPU")]
    TimedOut(u64),
}
