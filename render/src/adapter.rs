//! Which adapter to draw with, of those that this machine has: hardware before software, Vulkan before OpenGL.

use crate::GpuError;

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
    /// The best whose `Gpu::label` contains this, in any case.
    Named(String),
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

/// The best adapter that fits the choice and can draw frames.
pub(crate) fn find(choice: &AdapterChoice) -> Result<wgpu::Adapter, GpuError> {
    let adapters = all();
    let labels: Vec<_> = adapters.iter().map(|adapter| label(&adapter.get_info())).collect();
    let Some(adapter) = adapters.into_iter().find(|adapter| choice.allows(&adapter.get_info())) else {
        return Err(GpuError::NoAdapter { wanted: choice.to_string(), found: found(&labels) });
    };
    fit(&adapter)?;
    Ok(adapter)
}

/// This machine's adapters, best first.
pub(crate) fn all() -> Vec<wgpu::Adapter> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let mut adapters = pollster::block_on(instance.enumerate_adapters(wgpu::Backends::all()));
    adapters.sort_by_key(|adapter| rank(&adapter.get_info()));
    adapters
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

/// Whether the “GPU” is a program on the CPU.
pub(crate) fn is_software(info: &wgpu::AdapterInfo) -> bool {
    let name = info.name.to_lowercase();
    info.device_type == wgpu::DeviceType::Cpu
        || ["llvmpipe", "lavapipe", "swiftshader", "softpipe"].iter().any(|part| name.contains(part))
}

/// Name and backend, for people.
pub(crate) fn label(info: &wgpu::AdapterInfo) -> String {
    format!("{}, {:?}", info.name, info.backend)
}

fn found(labels: &[String]) -> String {
    if labels.is_empty() {
        return "this machine shows none at all".into();
    }
    format!("this machine has {}", labels.join("; "))
}

/// Blending into 16-bit floats is optional in OpenGL ES 3.0.
fn fit(adapter: &wgpu::Adapter) -> Result<(), GpuError> {
    let features = adapter.get_texture_format_features(crate::format::LINEAR_FORMAT);
    let can = features.allowed_usages.contains(wgpu::TextureUsages::RENDER_ATTACHMENT)
        && features.flags.contains(wgpu::TextureFormatFeatureFlags::BLENDABLE);
    if can {
        return Ok(());
    }
    Err(GpuError::Unfit { adapter: label(&adapter.get_info()), missing: "blend into 16-bit floats" })
}

#[cfg(test)]
mod tests {
    use super::*;
    use wgpu::{Backend, DeviceType};

    fn info(name: &str, device_type: DeviceType, backend: Backend) -> wgpu::AdapterInfo {
        wgpu::AdapterInfo { name: name.into(), ..wgpu::AdapterInfo::new(device_type, backend) }
    }

    #[test]
    fn hardware_then_vulkan_then_opengl() {
        let mut infos = [
            info("llvmpipe (LLVM 15)", DeviceType::Other, Backend::Gl),
            info("llvmpipe (LLVM 15)", DeviceType::Cpu, Backend::Vulkan),
            info("Some GPU", DeviceType::Other, Backend::Gl),
            info("Some GPU", DeviceType::IntegratedGpu, Backend::Vulkan),
            info("Large GPU", DeviceType::DiscreteGpu, Backend::Vulkan),
        ];
        infos.sort_by_key(rank);
        assert_eq!(
            infos.each_ref().map(label),
            [
                "Large GPU, Vulkan",
                "Some GPU, Vulkan",
                "Some GPU, Gl",
                "llvmpipe (LLVM 15), Vulkan",
                "llvmpipe (LLVM 15), Gl"
            ]
        );
        assert_eq!(infos.each_ref().map(is_software), [false, false, false, true, true]);
        assert!(AdapterChoice::Named("large gpu".into()).allows(&infos[0]));
        assert!(!AdapterChoice::HardwareOnly.allows(&infos[3]));
    }

    #[test]
    fn a_choice_that_nothing_fits_says_what_there_is() {
        let Err(error) = find(&AdapterChoice::Named("no such adapter".into())) else {
            unreachable!("there is none of that name");
        };
        let message = error.to_string();
        assert!(message.contains("no such adapter") && message.contains("this machine"), "{message}");
    }
}
