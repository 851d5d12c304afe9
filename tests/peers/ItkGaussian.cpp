// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkGaussian.h"

#include <itkDiscreteGaussianImageFilter.h>
#include <itkImage.h>

#include <chrono>

namespace peer {

ItkGaussian itkGaussian(const glm::ivec3& size, const glm::dvec3& spacingMm,
    std::span<const std::uint8_t> mask, double sigmaMm)
{
    using Image = itk::Image<float, 3>;
    Image::RegionType region;
    Image::SpacingType spacing;
    for (unsigned axis = 0; axis < 3; ++axis) {
        region.SetSize(axis, static_cast<itk::SizeValueType>(size[static_cast<int>(axis)]));
        spacing[axis] = spacingMm[static_cast<int>(axis)];
    }
    const auto image = Image::New();
    image->SetRegions(region);
    image->SetSpacing(spacing);
    image->Allocate();
    float* voxels = image->GetBufferPointer();
    for (std::size_t voxel = 0; voxel < mask.size(); ++voxel)
        voxels[voxel] = mask[voxel] == 1 ? 1.0F : 0.0F;

    const auto filter = itk::DiscreteGaussianImageFilter<Image, Image>::New();
    filter->SetInput(image);
    filter->SetVariance(sigmaMm * sigmaMm);
    filter->SetMaximumError(1e-5);
    filter->SetMaximumKernelWidth(512);
    filter->SetUseImageSpacing(true);

    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;

    const float* first = filter->GetOutput()->GetBufferPointer();
    return {std::vector<float>(first, first + mask.size()), spent.count()};
}

} // namespace peer
