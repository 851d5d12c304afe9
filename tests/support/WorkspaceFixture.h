// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reference/ReferenceEngine.h"
#include "ui/Workspace.h"

namespace test {

/// A ball of "bone" around "brain" with a "ventricle" in it, in air: 40³ voxels of 1 × 1 × 1.5 mm,
/// CT in HU. Concentric about the middle voxel (20, 20, 20), which lies at the LPS origin.
namespace smallHead {
constexpr int side = 40;
constexpr double boneHu = 900.0; ///< 13 mm ≤ distance < 16 mm
constexpr double brainHu = 40.0; ///< 5 mm ≤ distance < 13 mm
constexpr double ventricleHu = 8.0; ///< distance < 5 mm
constexpr double airHu = -1000.0;
[[nodiscard]] core::LoadedVolume volume();
/// Voxels that hold exactly this value.
[[nodiscard]] std::int64_t voxelsOf(double hu);
} // namespace smallHead

/// Draws nothing.
class NoFrames : public gpu::FrameSource {
public:
    void request(gpu::FrameRequest) override { }
    void forget(gpu::ViewId) override { }
    void setListener(Listener) override { }
    void updateSurface(core::SurfaceUpdate) override { }
};

/// A workspace with a volume open, the small head unless told otherwise, over the oracle.
class WorkspaceFixture {
public:
    explicit WorkspaceFixture(core::LoadedVolume volume = smallHead::volume());

    [[nodiscard]] core::EditSession& session() { return *workspace.session(); }
    /// Applies an edit and waits for it; a failure ends the test program with its reason.
    void apply(const core::Edit& edit);
    void settle();
    /// A seed stroke of one voxel in the middle.
    [[nodiscard]] static core::SeedStroke middleSeed(int segment);

    reference::ReferenceEngine engine;
    NoFrames frames;
    ui::Workspace workspace;
};

} // namespace test
