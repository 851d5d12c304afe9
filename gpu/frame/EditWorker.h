// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/textures/PieceTextures.h"
#include "gpu/gl/SoftwareDriver.h"
#include "gpu/scene/Scene.h"

#include <bitset>
#include <optional>
#include <vector>

namespace gpu {

class EngineThread;
class ShaderLibrary;
class VolumeTextures;

/// What an edit engine works with; all of it outlives the engine.
struct EditContext {
    EngineThread& thread;
    VolumeTextures& textures;
    const ShaderLibrary& shaders;
    /// Whether kernels or the processor copy bricks, find barriers and advance simple fronts of
    /// growth.
    WorkBy work = WorkBy::Driver;
};

/// The part of the edit engine that runs on the engine thread, as the thread's loop and the frame
/// scheduler use it. Every member is called on that thread, with the context current.
class EditWorker {
public:
    virtual ~EditWorker() = default;

    /// Does one slice of work, at most about 10 ms.
    /// @return whether more is to do at once. For work that becomes due later (a paced growth) it
    /// calls EngineThread::wakeAt().
    virtual bool work() = 0;

    /// Sets the labels that VolumeTextures::segmentation() shows, and which of them are
    /// translucent; none at first. Does not wait: work() updates the map and marks it dirty.
    virtual void showSegments(
        const std::bitset<256>& labels, const std::bitset<256>& translucent) = 0;

    /// Sets the sources whose footprints VolumeTextures::pieces() holds; none at first. Updated
    /// like the segmentation map.
    virtual void showPieces(const std::vector<PieceSource>& sources) = 0;

    /// Sets the label plane whose growth pictures show; the first one at first.
    virtual void showGrowth(std::uint8_t plane) = 0;

    /// Sets how VolumeTextures::segmentation() shows a segment while a valid tolerance field of it
    /// exists.
    virtual void showAtTolerance(const std::optional<ToleranceDisplay>& shown) = 0;

    /// Requests that the kernels of all tools are run once, one tool in each slice of work() that
    /// has nothing else to do. Drivers compile a kernel when it first runs, and no pen should wait
    /// for that. Has an effect only once.
    virtual void warmUp() = 0;
};

} // namespace gpu
