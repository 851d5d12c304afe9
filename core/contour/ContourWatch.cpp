// SPDX-License-Identifier: Apache-2.0
#include "core/contour/ContourWatch.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <utility>

namespace core {

double watchedContourBytes(std::size_t voxelsOfBox, std::size_t changes)
{
    constexpr double ground = 3.0; // flags and code
    constexpr double evolving = 5.0; // the same, g, and the state that goes along
    constexpr double shown = 4.0; // the state, the next one, and those of pictures under way
    return (ground + evolving + shown) * double(voxelsOfBox)
        + double(sizeof(std::uint32_t)) * double(changes);
}

ContourEnd watchContour(ContourRule rule, const ContourGround& ground, const ContourWish& wish,
    const Progress& progress, const ContourReports& reports)
{
    using Clock = std::chrono::steady_clock;
    constexpr auto between = std::chrono::milliseconds(15);
    ContourState state(ground.box, ground.voxels);
    auto track = std::make_shared<ContourTrack>(state);
    ContourEvolution evolution(std::move(rule), ground);
    std::size_t changes = 0;
    const auto hasRoom = [&] {
        return watchedContourBytes(ground.voxels.size(), changes) <= wish.bytes;
    };
    const auto goesOn = [&](int most) {
        return evolution.generation() < most && hasRoom() && evolution.step(progress);
    };
    const auto last = [&] {
        state.pass(*evolution.lastChanged());
        changes += evolution.lastChanges();
        return ContourGeneration{
            .changed = evolution.lastChanged(), .gained = state.gained(), .lost = state.lost()};
    };
    while (goesOn(std::min(wish.silent, wish.generations)))
        track->append(last());
    if (progress.cancelled())
        return ContourEnd::Cancelled;
    track->goTo(track->known());
    reports.begun(std::exchange(track, nullptr), std::make_shared<const ContourState>(state));
    std::vector<ContourGeneration> waiting;
    Clock::time_point reported = Clock::now();
    while (goesOn(wish.generations)) {
        waiting.push_back(last());
        if (Clock::now() - reported < between)
            continue;
        reports.further(std::exchange(waiting, {}));
        reported = Clock::now();
    }
    if (!waiting.empty())
        reports.further(std::move(waiting));
    if (evolution.rests())
        return ContourEnd::Rests;
    if (evolution.generation() >= wish.generations)
        return ContourEnd::AllGenerations;
    return hasRoom() ? ContourEnd::Cancelled : ContourEnd::OutOfMemory;
}

} // namespace core
