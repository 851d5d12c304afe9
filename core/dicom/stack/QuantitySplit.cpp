// SPDX-License-Identifier: Apache-2.0
#include "core/dicom/stack/QuantitySplit.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace core {

namespace {

/// All of one place; none unless each of its images says what it measures.
std::set<Clause> quantitiesAt(const SlicePlace& place)
{
    std::set<Clause> quantities;
    for (const ImageHeader& image : place.images) {
        if (image.quantity.isEmpty())
            return {};
        quantities.insert(image.quantity);
    }
    return quantities;
}

} // namespace

std::vector<QuantityImages> takeApartByQuantity(std::vector<SlicePlace>& places)
{
    if (places.empty())
        return {};
    const std::set<Clause> quantities = quantitiesAt(places.front());
    if (quantities.size() < 2
        || !std::all_of(places.begin(), places.end(),
            [&](const SlicePlace& place) { return quantitiesAt(place) == quantities; }))
        return {};
    std::map<Clause, std::vector<ImageHeader>> apart;
    for (SlicePlace& place : places) {
        for (ImageHeader& image : place.images)
            apart[image.quantity].push_back(std::move(image));
    }
    std::vector<QuantityImages> all;
    for (auto& [quantity, images] : apart)
        all.push_back({.quantity = quantity, .images = std::move(images)});
    const auto comesFirst = [](const QuantityImages& a, const QuantityImages& b) {
        const ImageHeader& x = a.images.front();
        const ImageHeader& y = b.images.front();
        return std::tie(x.instanceNumber, x.file, x.frame)
            < std::tie(y.instanceNumber, y.file, y.frame);
    };
    std::sort(all.begin(), all.end(), comesFirst);
    return all;
}

} // namespace core
