// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/fields/textures/PieceTextures.h"
#include "gpu/scene/Scene.h"

#include <bitset>
#include <optional>
#include <vector>

namespace gpu {

class EngineThread;
class ShaderLibrary;
class VolumeTextures;

/// Where an edit engine works; all of it outlives the engine.
struct EditContext {
    EngineThread& thread;
    VolumeTextures& textures;
    const ShaderLibrary& shaders;
};

/// The part of the edit engine that runs on the engine thread, as the thread's loop and the frame
/// scheduler see it. Every member is called there, with the context current.
class EditWorker {
public:
    virtual ~EditWorker() = default;

    /// One slice of at most about 10 ms. @return whether more is to do at once; work that becomes
    /// due later (a paced growth) asks EngineThread::wakeAt().
    virtual bool work() = 0;

    /// These labels are to be in VolumeTextures::segmentation() from now on. Does not wait: the map
    /// follows by work(), which marks it dirty. None at first.
    virtual void showSegments(const std::bitset<256>& labels) = 0;

    /// The footprints of these are to be in VolumeTextures::pieces() from now on; they follow like
    /// the map. None at first.
    virtual void showPieces(const std::vector<PieceSource>& sources) = 0;

    /// So is a segment to be in VolumeTextures::segmentation() while a tolerance field of it
    /// stands.
    virtual void showAtTolerance(const std::optional<ToleranceDisplay>& shown) = 0;

    /// Drivers compile a kernel when it first runs: run those of all tools now, a tool in each
    /// slice of work() that has nothing else to do, so that no pen has to wait for it. Once.
    virtual void warmUp() = 0;
};

} // namespace gpu
