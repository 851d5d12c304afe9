// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkDistances.h"

#include <itkImportImageFilter.h>
#include <itkSignedMaurerDistanceMapImageFilter.h>

#include <chrono>

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

} // namespace peer
