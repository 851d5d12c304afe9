// SPDX-License-Identifier: Apache-2.0
#include "tests/peers/ItkConnectedThreshold.h"

#include <itkConnectedThresholdImageFilter.h>
#include <itkImportImageFilter.h>

#include <chrono>

namespace peer {

template <class Value>
ItkGrown itkConnectedThreshold(const glm::ivec3& size, std::span<const Value> values,
    std::span<const glm::ivec3> seeds, Value lower, Value upper)
{
    using Image = itk::Image<Value, 3>;
    using Mask = itk::Image<std::uint8_t, 3>;
    typename Image::RegionType region;
    for (unsigned axis = 0; axis < 3; ++axis)
        region.SetSize(axis, static_cast<itk::SizeValueType>(size[static_cast<int>(axis)]));

    const auto import = itk::ImportImageFilter<Value, 3>::New();
    import->SetRegion(region);
    import->SetImportPointer(const_cast<Value*>(values.data()), values.size(), false);
    import->Update();

    using Filter = itk::ConnectedThresholdImageFilter<Image, Mask>;
    const auto filter = Filter::New();
    filter->SetInput(import->GetOutput());
    filter->SetConnectivity(Filter::FaceConnectivity);
    filter->SetLower(lower);
    filter->SetUpper(upper);
    filter->SetReplaceValue(1);
    for (const glm::ivec3& seed : seeds)
        filter->AddSeed({{seed.x, seed.y, seed.z}});

    const auto start = std::chrono::steady_clock::now();
    filter->Update();
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;

    const std::uint8_t* first = filter->GetOutput()->GetBufferPointer();
    return {std::vector<std::uint8_t>(first, first + values.size()), spent.count()};
}

template ItkGrown itkConnectedThreshold(const glm::ivec3&, std::span<const std::int16_t>,
    std::span<const glm::ivec3>, std::int16_t, std::int16_t);
template ItkGrown itkConnectedThreshold(
    const glm::ivec3&, std::span<const float>, std::span<const glm::ivec3>, float, float);

} // namespace peer
