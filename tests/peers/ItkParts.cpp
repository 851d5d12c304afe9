// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkParts.h"

#include "tests/peers/ItkImages.h"

#include <itkBinaryFillholeImageFilter.h>
#include <itkConnectedComponentImageFilter.h>
#include <itkRelabelComponentImageFilter.h>

namespace peer {

namespace {

using Labels = itk::Image<std::uint32_t, 3>;
using Components = itk::ConnectedComponentImageFilter<MaskImage, Labels>;
using Sorting = itk::RelabelComponentImageFilter<Labels, Labels>;

/// Finds parts and numbers them by their size, 1 the largest.
class SortedParts {
public:
    SortedParts(const GridMask& mask, int leastVoxels)
    {
        m_components->SetInput(imageOn(mask));
        m_components->SetFullyConnected(true);
        m_sorting->SetInput(m_components->GetOutput());
        m_sorting->SetMinimumObjectSize(static_cast<Sorting::ObjectSizeType>(leastVoxels));
    }
    [[nodiscard]] Sorting& last() const { return *m_sorting; }

private:
    // An image does not keep the filter that makes it.
    Components::Pointer m_components = Components::New();
    Sorting::Pointer m_sorting = Sorting::New();
};

} // namespace

ItkMask itkPartsFrom(const GridMask& mask, int leastVoxels)
{
    return maskFrom(SortedParts(mask, leastVoxels).last());
}

ItkMask itkLargestPart(const GridMask& mask)
{
    const SortedParts parts(mask, 0);
    ItkMask largest;
    largest.milliseconds = timeOf(parts.last());
    const std::uint32_t* first = parts.last().GetOutput()->GetBufferPointer();
    largest.voxels.resize(mask.voxels.size());
    for (std::size_t voxel = 0; voxel < mask.voxels.size(); ++voxel)
        largest.voxels[voxel] = first[voxel] == 1 ? 1 : 0;
    return largest;
}

ItkMask itkNumberedParts(const GridMask& mask, int leastVoxels)
{
    const SortedParts parts(mask, leastVoxels);
    ItkMask numbered;
    numbered.milliseconds = timeOf(parts.last());
    const std::uint32_t* first = parts.last().GetOutput()->GetBufferPointer();
    numbered.voxels.assign(mask.voxels.begin(), mask.voxels.end());
    for (std::size_t voxel = 0; voxel < mask.voxels.size(); ++voxel) {
        if (first[voxel] > 1)
            numbered.voxels[voxel] = static_cast<std::uint8_t>(first[voxel]);
    }
    return numbered;
}

int itkPartCount(const GridMask& mask, int leastVoxels)
{
    const SortedParts parts(mask, leastVoxels);
    parts.last().Update();
    return static_cast<int>(parts.last().GetNumberOfObjects());
}

ItkMask itkFilledHoles(const GridMask& mask)
{
    const auto filter = itk::BinaryFillholeImageFilter<MaskImage>::New();
    filter->SetInput(imageOn(mask));
    filter->SetForegroundValue(1);
    filter->SetFullyConnected(false);
    return maskFrom(*filter);
}

} // namespace peer
