// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkNeighborhoodConnected.h"

#include <itkImportImageFilter.h>
#include <itkNeighborhoodConnectedImageFilter.h>

namespace peer {

std::vector<std::uint8_t> itkNeighborhoodConnected(const glm::ivec3& size,
    std::span<const std::uint16_t> values, std::span<const glm::ivec3> seeds, std::uint16_t lower,
    std::uint16_t upper)
{
    using Image = itk::Image<std::uint16_t, 3>;
    using Mask = itk::Image<std::uint8_t, 3>;
    Image::RegionType region;
    for (unsigned axis = 0; axis < 3; ++axis)
        region.SetSize(axis, static_cast<itk::SizeValueType>(size[static_cast<int>(axis)]));
    const auto import = itk::ImportImageFilter<std::uint16_t, 3>::New();
    import->SetRegion(region);
    import->SetImportPointer(const_cast<std::uint16_t*>(values.data()), values.size(), false);
    import->Update();

    const auto filter = itk::NeighborhoodConnectedImageFilter<Image, Mask>::New();
    filter->SetInput(import->GetOutput());
    filter->SetLower(lower);
    filter->SetUpper(upper);
    filter->SetReplaceValue(1);
    Image::SizeType radius;
    radius.Fill(1);
    filter->SetRadius(radius);
    for (const glm::ivec3& seed : seeds)
        filter->AddSeed({{seed.x, seed.y, seed.z}});
    filter->Update();
    const std::uint8_t* first = filter->GetOutput()->GetBufferPointer();
    return {first, first + values.size()};
}

} // namespace peer
