// SPDX-License-Identifier: Apache-2.0
#include "tests/support/ConnectedThreshold.h"

#ifdef BURIN_WITH_ITK
#include <itkConnectedThresholdImageFilter.h>
#include <itkImage.h>
#endif

#include <algorithm>

namespace test {

#ifdef BURIN_WITH_ITK

std::optional<std::vector<std::uint8_t>> connectedThreshold(const glm::ivec3& size,
    std::span<const std::uint16_t> codes, int low, int high, const std::vector<glm::ivec3>& seeds)
{
    using Codes = itk::Image<std::uint16_t, 3>;
    using Mask = itk::Image<std::uint8_t, 3>;
    const auto image = Codes::New();
    const Codes::SizeType extent{
        {itk::SizeValueType(size.x), itk::SizeValueType(size.y), itk::SizeValueType(size.z)}};
    image->SetRegions(Codes::RegionType(extent));
    image->Allocate();
    std::copy(codes.begin(), codes.end(), image->GetBufferPointer());

    using Filter = itk::ConnectedThresholdImageFilter<Codes, Mask>;
    const auto filter = Filter::New();
    filter->SetInput(image);
    filter->SetConnectivity(Filter::ConnectivityEnum::FaceConnectivity);
    filter->SetLower(std::uint16_t(low));
    filter->SetUpper(std::uint16_t(high));
    filter->SetReplaceValue(1);
    for (const glm::ivec3& seed : seeds)
        filter->AddSeed({{seed.x, seed.y, seed.z}});
    filter->Update();
    const std::uint8_t* grown = filter->GetOutput()->GetBufferPointer();
    return std::vector<std::uint8_t>(grown, grown + codes.size());
}

#else

std::optional<std::vector<std::uint8_t>> connectedThreshold(
    const glm::ivec3&, std::span<const std::uint16_t>, int, int, const std::vector<glm::ivec3>&)
{
    return std::nullopt;
}

#endif

} // namespace test
