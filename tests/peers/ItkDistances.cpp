// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkDistances.h"

#include "tests/peers/ItkImages.h"

#include <itkBinaryDilateImageFilter.h>
#include <itkFlatStructuringElement.h>
#include <itkImportImageFilter.h>
#include <itkMaskImageFilter.h>
#include <itkMinimumMaximumImageCalculator.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace peer {

ItkDistances itkDistances(
    const glm::ivec3& size, const glm::dvec3& spacingMm, std::span<const std::uint8_t> mask)
{
    using Mask = itk::Image<std::uint8_t, 3>;
    using Distances = itk::Image<float, 3>;
    Mask::RegionType region;
    Mask::SpacingType spacing;
    for (unsigned axis = 0; axis < 3; ++axis) {
        region.SetSize(axis, static_cast<itk::SizeValueType>(size[static_cast<int>(axis)]));
        spacing[axis] = spacingMm[static_cast<int>(axis)];
    }
    const auto import = itk::ImportImageFilter<std::uint8_t, 3>::New();
    import->SetRegion(region);
    import->SetSpacing(spacing);
    import->SetImportPointer(const_cast<std::uint8_t*>(mask.data()), mask.size(), false);
    import->Update();

    const auto filter = itk::SignedMaurerDistanceMapImageFilter<Mask, Distances>::New();
    filter->SetInput(import->GetOutput());
    filter->SetBackgroundValue(0);
    filter->SetInsideIsPositive(false);
    filter->SetSquaredDistance(true);
    filter->SetUseImageSpacing(true);

    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;

    const float* first = filter->GetOutput()->GetBufferPointer();
    return {std::vector<float>(first, first + mask.size()), spent.count()};
}

ItkGap itkGap(const GridMask& mask, const GridMask& other)
{
    using Distances = itk::Image<float, 3>;
    using Kernel = itk::FlatStructuringElement<3>;
    Kernel kernel;
    kernel.SetDecomposable(false);
    kernel.SetRadius(1);
    for (unsigned at = 0; at < kernel.Size(); ++at)
        kernel[at] = true;
    const auto dilate = itk::BinaryDilateImageFilter<MaskImage, MaskImage, Kernel>::New();
    dilate->SetInput(imageOn(mask));
    dilate->SetKernel(kernel);
    dilate->SetForegroundValue(1);
    const auto distances = itk::SignedMaurerDistanceMapImageFilter<MaskImage, Distances>::New();
    distances->SetInput(dilate->GetOutput());
    distances->SetBackgroundValue(0);
    distances->SetInsideIsPositive(false);
    distances->SetSquaredDistance(true);
    distances->SetUseImageSpacing(true);
    const auto within = itk::MaskImageFilter<Distances, MaskImage>::New();
    const MaskImage::Pointer others = imageOn(other);
    within->SetInput(distances->GetOutput());
    within->SetMaskImage(others);
    within->SetOutsideValue(std::numeric_limits<float>::max());
    const auto least = itk::MinimumMaximumImageCalculator<Distances>::New();

    const auto start = std::chrono::steady_clock::now();
    within->Update();
    least->SetImage(within->GetOutput());
    least->ComputeMinimum();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    return {std::sqrt(std::max(0.0, double(least->GetMinimum()))), spent.count()};
}

} // namespace peer
