// SPDX-License-Identifier: Apache-2.0
#pragma once

// For the sources of peers alone, which see ITK.

#include "tests/peers/ItkMask.h"

#include <itkImage.h>
#include <itkImportImageFilter.h>

#include <chrono>

namespace peer {

using MaskImage = itk::Image<std::uint8_t, 3>;

/// An image on the caller's own voxels, which must outlive it.
template <class Value>
typename itk::Image<Value, 3>::Pointer imageOn(
    const glm::ivec3& size, const glm::dvec3& spacingMm, std::span<const Value> voxels)
{
    typename itk::Image<Value, 3>::RegionType region;
    typename itk::Image<Value, 3>::SpacingType spacing;
    for (unsigned axis = 0; axis < 3; ++axis) {
        region.SetSize(axis, static_cast<itk::SizeValueType>(size[static_cast<int>(axis)]));
        spacing[axis] = spacingMm[static_cast<int>(axis)];
    }
    const auto import = itk::ImportImageFilter<Value, 3>::New();
    import->SetRegion(region);
    import->SetSpacing(spacing);
    import->SetImportPointer(const_cast<Value*>(voxels.data()), voxels.size(), false);
    import->Update();
    typename itk::Image<Value, 3>::Pointer image = import->GetOutput();
    image->DisconnectPipeline();
    return image;
}

inline MaskImage::Pointer imageOn(const GridMask& mask)
{
    return imageOn(mask.size, mask.spacingMm, mask.voxels);
}

/// Runs what leads to a filter's output. @return milliseconds
template <class Filter> double timeOf(Filter& filter)
{
    const auto start = std::chrono::steady_clock::now();
    filter.Update();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    return spent.count();
}

/// What a filter makes of masks: 1 where its output is not 0.
template <class Filter> ItkMask maskFrom(Filter& filter)
{
    ItkMask mask;
    mask.milliseconds = timeOf(filter);
    const auto* output = filter.GetOutput();
    const auto* first = output->GetBufferPointer();
    const auto count = output->GetLargestPossibleRegion().GetNumberOfPixels();
    mask.voxels.resize(count);
    for (itk::SizeValueType voxel = 0; voxel < count; ++voxel)
        mask.voxels[voxel] = first[voxel] != 0 ? 1 : 0;
    return mask;
}

} // namespace peer
