// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkLabels.h"

#include "tests/peers/ItkImages.h"

#include <itkChangeLabelImageFilter.h>
#include <itkImageRegionConstIteratorWithIndex.h>
#include <itkMaskNegatedImageFilter.h>
#include <itkMultiThreaderBase.h>

#include <chrono>

namespace peer {

namespace {

/// What a filter makes of labels, as it is.
template <class Filter> ItkMask labelsFrom(Filter& filter)
{
    ItkMask labels;
    labels.milliseconds = timeOf(filter);
    const auto* output = filter.GetOutput();
    const std::uint8_t* first = output->GetBufferPointer();
    labels.voxels.assign(first, first + output->GetLargestPossibleRegion().GetNumberOfPixels());
    return labels;
}

} // namespace

ItkMask itkRelabelled(const GridMask& labels, std::span<const ChangedLabel> changes)
{
    const auto filter = itk::ChangeLabelImageFilter<MaskImage, MaskImage>::New();
    filter->SetInput(imageOn(labels));
    filter->InPlaceOff(); // the voxels are the caller's
    for (const ChangedLabel& change : changes)
        filter->SetChange(change.from, change.to);
    return labelsFrom(*filter);
}

ItkMask itkOutsideOf(const GridMask& labels, const GridMask& mask, std::uint8_t there)
{
    const auto filter = itk::MaskNegatedImageFilter<MaskImage, MaskImage>::New();
    const MaskImage::Pointer masking = imageOn(mask);
    filter->SetInput(imageOn(labels));
    filter->InPlaceOff();
    filter->SetMaskImage(masking);
    filter->SetOutsideValue(there);
    return labelsFrom(*filter);
}

ItkMask itkSplitByPlane(const GridMask& mask, const GridPlace& place, const glm::dvec3& pointLps,
    const glm::dvec3& normalLps, std::uint8_t beyond)
{
    const MaskImage::Pointer image = imageOn(mask);
    MaskImage::PointType origin;
    MaskImage::DirectionType direction;
    for (unsigned row = 0; row < 3; ++row) {
        origin[row] = place.originLps[static_cast<int>(row)];
        for (unsigned column = 0; column < 3; ++column)
            direction[row][column] =
                place.direction[static_cast<int>(column)][static_cast<int>(row)];
    }
    image->SetOrigin(origin);
    image->SetDirection(direction);

    ItkMask split{.voxels = {mask.voxels.begin(), mask.voxels.end()}};
    const auto start = std::chrono::steady_clock::now();
    itk::MultiThreaderBase::New()->ParallelizeImageRegion<3>(
        image->GetLargestPossibleRegion(),
        [&](const MaskImage::RegionType& region) {
            itk::ImageRegionConstIteratorWithIndex<MaskImage> at(image, region);
            for (; !at.IsAtEnd(); ++at) {
                if (at.Get() == 0)
                    continue;
                MaskImage::PointType point;
                image->TransformIndexToPhysicalPoint(at.GetIndex(), point);
                const glm::dvec3 lps(point[0], point[1], point[2]);
                if (glm::dot(normalLps, lps - pointLps) > 0.0)
                    split.voxels[static_cast<std::size_t>(image->ComputeOffset(at.GetIndex()))] =
                        beyond;
            }
        },
        nullptr);
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    split.milliseconds = spent.count();
    return split;
}

} // namespace peer
