//! The backends that the tests draw on, each opened once. A backend that this machine lacks gives *ignored* tests, or
//! failed ones where CLOUDWRIGHT_REQUIRE_GPU=1 says that it must be there.

use cloudwright_render::{AdapterChoice, Gpu, GpuRenderer, wgpu};
use std::sync::{Arc, Mutex};

/// A backend with its renderer, if this machine has it.
#[derive(Clone)]
pub struct Backend {
    /// For test names.
    pub name: &'static str,
    /// How to open another device on it.
    pub choice: AdapterChoice,
    /// The device and its renderer, or why there is none.
    pub opened: Result<Arc<(Gpu, Mutex<GpuRenderer>)>, String>,
}

impl Backend {
    /// Vulkan and OpenGL, each there or not.
    pub fn all() -> Vec<Self> {
        [("vulkan", wgpu::Backend::Vulkan), ("gl", wgpu::Backend::Gl)]
            .map(|(name, backend)| {
                let choice = AdapterChoice::On(backend);
                Self { name, opened: open(&choice), choice }
            })
            .to_vec()
    }
}

fn open(choice: &AdapterChoice) -> Result<Arc<(Gpu, Mutex<GpuRenderer>)>, String> {
    let gpu = Gpu::headless(choice).map_err(|error| error.to_string())?;
    let renderer = GpuRenderer::new(&gpu).map_err(|error| error.to_string())?;
    Ok(Arc::new((gpu, Mutex::new(renderer))))
}

/// Whether a missing adapter is a failure.
pub fn required() -> bool {
    std::env::var("CLOUDWRIGHT_REQUIRE_GPU").is_ok_and(|value| value == "1")
}
