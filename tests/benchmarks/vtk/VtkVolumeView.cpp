// SPDX-License-Identifier: Apache-2.0
#include "tests/benchmarks/vtk/VtkVolumeView.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkNew.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShortArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cstring>

namespace bench {

struct VtkVolumeView::Parts {
    vtkNew<vtkImageData> image;
    vtkNew<vtkGPUVolumeRayCastMapper> gpu;
    vtkNew<vtkFixedPointVolumeRayCastMapper> fixedPoint;
    vtkNew<vtkVolume> volume;
    vtkNew<vtkRenderer> renderer;
    vtkNew<vtkRenderWindow> window;
    Mapper kind = Mapper::Gpu;
    glm::ivec2 size{0};

    [[nodiscard]] vtkVolumeMapper* mapper()
    {
        if (kind == Mapper::Gpu)
            return gpu;
        return fixedPoint;
    }
};

VtkVolumeView::VtkVolumeView(const core::VolumeGeometry& geometry,
    std::span<const std::int16_t> hounsfield, const glm::ivec2& size, Mapper mapper)
    : m_parts(std::make_unique<Parts>())
{
    Parts& parts = *m_parts;
    parts.kind = mapper;
    parts.size = size;
    const glm::dvec3 spacing = geometry.spacingMm();
    const glm::dvec3 origin = geometry.originLps();
    parts.image->SetDimensions(geometry.size.x, geometry.size.y, geometry.size.z);
    parts.image->SetSpacing(spacing.x, spacing.y, spacing.z);
    parts.image->SetOrigin(origin.x, origin.y, origin.z);
    vtkNew<vtkShortArray> scalars;
    scalars->SetArray(
        const_cast<short*>(hounsfield.data()), static_cast<vtkIdType>(hounsfield.size()), 1);
    parts.image->GetPointData()->SetScalars(scalars);

    parts.mapper()->SetInputDataObject(parts.image);
    parts.volume->SetMapper(parts.mapper());
    parts.renderer->AddVolume(parts.volume);
    parts.renderer->SetBackground(0.0, 0.0, 0.0);
    parts.window->SetOffScreenRendering(1);
    parts.window->SetMultiSamples(0);
    parts.window->SetSize(size.x, size.y);
    parts.window->AddRenderer(parts.renderer);
}

VtkVolumeView::~VtkVolumeView() = default;

void VtkVolumeView::setUp(const gpu::VolumeScene& scene, double sampleMm)
{
    Parts& parts = *m_parts;
    vtkNew<vtkColorTransferFunction> colour;
    vtkNew<vtkPiecewiseFunction> opacity;
    vtkNew<vtkVolumeProperty> property;
    property->SetInterpolationTypeToLinear();
    property->SetScalarOpacityUnitDistance(1.0);
    property->SetAmbient(0.3);
    property->SetDiffuse(0.75);
    property->SetSpecular(0.1);
    property->SetSpecularPower(28.0);
    int blend = vtkVolumeMapper::COMPOSITE_BLEND;
    const double threshold = scene.surfaceThreshold;
    switch (scene.mode) {
    case gpu::RenderMode::Surface:
        property->ShadeOn();
        colour->AddRGBPoint(threshold, 0.965, 0.895, 0.775);
        if (parts.kind == Mapper::Gpu) {
            blend = vtkVolumeMapper::ISOSURFACE_BLEND;
            property->GetIsoSurfaceValues()->SetValue(0, threshold);
            opacity->AddPoint(threshold, 1.0);
        } else {
            // It knows no isosurface: a step is its opaque surface.
            opacity->AddPoint(threshold - 1.0, 0.0);
            opacity->AddPoint(threshold, 1.0);
        }
        break;
    case gpu::RenderMode::Dvr:
        property->ShadeOn();
        for (const gpu::TransferFunction::Point& point : scene.transferFunction.points) {
            colour->AddRGBPoint(point.value, double(point.rgb >> 16 & 255U) / 255.0,
                double(point.rgb >> 8 & 255U) / 255.0, double(point.rgb & 255U) / 255.0);
            opacity->AddPoint(point.value, point.opacity);
        }
        break;
    case gpu::RenderMode::Mip:
    case gpu::RenderMode::Xray: {
        const bool mean = scene.mode == gpu::RenderMode::Xray;
        blend = mean ? vtkVolumeMapper::AVERAGE_INTENSITY_BLEND
                     : vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND;
        const core::WindowLevel& window = mean ? scene.xrayWindow : scene.mipWindow;
        const double low = window.centre - 0.5 * window.width;
        const double high = window.centre + 0.5 * window.width;
        colour->AddRGBPoint(low, 0.0, 0.0, 0.0);
        colour->AddRGBPoint(high, 1.0, 1.0, 1.0);
        opacity->AddPoint(low, 1.0);
        opacity->AddPoint(high, 1.0);
        break;
    }
    }
    property->SetColor(colour);
    property->SetScalarOpacity(opacity);
    parts.volume->SetProperty(property);
    parts.mapper()->SetBlendMode(blend);
    const auto fullResolution = [sampleMm](auto& mapper) {
        mapper->SetAutoAdjustSampleDistances(0);
        mapper->SetImageSampleDistance(1.0F);
        mapper->SetSampleDistance(static_cast<float>(sampleMm));
    };
    fullResolution(parts.gpu);
    fullResolution(parts.fixedPoint);
    parts.fixedPoint->SetInteractiveSampleDistance(static_cast<float>(sampleMm));
}

std::vector<std::uint8_t> VtkVolumeView::draw(const gpu::VolumeScene& scene)
{
    Parts& parts = *m_parts;
    vtkCamera* camera = parts.renderer->GetActiveCamera();
    camera->SetPosition(scene.eyeLps.x, scene.eyeLps.y, scene.eyeLps.z);
    camera->SetFocalPoint(scene.targetLps.x, scene.targetLps.y, scene.targetLps.z);
    camera->SetViewUp(scene.up.x, scene.up.y, scene.up.z);
    camera->SetParallelProjection(1);
    camera->SetParallelScale(0.5 * scene.heightMm);
    parts.renderer->ResetCameraClippingRange();
    parts.window->Render();
    vtkNew<vtkUnsignedCharArray> bytes;
    parts.window->GetRGBACharPixelData(0, 0, parts.size.x - 1, parts.size.y - 1, 0, bytes);
    const std::size_t row = 4 * std::size_t(parts.size.x);
    std::vector<std::uint8_t> rgba(row * std::size_t(parts.size.y));
    for (int y = 0; y < parts.size.y; ++y)
        std::memcpy(rgba.data() + row * std::size_t(parts.size.y - 1 - y),
            bytes->GetPointer(static_cast<vtkIdType>(row) * y), row);
    return rgba;
}

std::string VtkVolumeView::rendererName()
{
    const std::string report = m_parts->window->ReportCapabilities();
    const std::string key = "OpenGL renderer string:";
    const std::size_t at = report.find(key);
    if (at == std::string::npos)
        return "unknown";
    const std::size_t first = report.find_first_not_of(' ', at + key.size());
    return report.substr(first, report.find('\n', first) - first);
}

} // namespace bench
