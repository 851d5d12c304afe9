// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "tests/reference/ReferenceEngine.h"
#include "tests/support/FakeFrames.h"
#include "ui/MainWindow.h"

#include <memory>

namespace test {

/// A small CT of nothing in particular, named after nobody: 64 × 48 × 40 voxels whose code is
/// 1000 + column, so that a value tells where it was read.
[[nodiscard]] core::LoadedVolume plainCt(const glm::dmat4& indexToWorld);

/// Index → LPS of an axial volume of 2 × 2 × 3 mm voxels around the origin, for a patient that lies
/// head first on the back, or on the front (rows and columns turned by the scanner's view of it).
[[nodiscard]] glm::dmat4 headFirstSupine();
[[nodiscard]] glm::dmat4 headFirstProne();
/// Rows along P and I as sagittal MR is stored.
[[nodiscard]] glm::dmat4 sagittalAcquisition();
/// Turned by 25° about x and 10° about z.
[[nodiscard]] glm::dmat4 oblique();

/// The real window over the oracle and pictures that tell positions.
class WindowFixture {
public:
    explicit WindowFixture(const glm::dmat4& indexToWorld, const QSize& size = QSize(1200, 800));
    explicit WindowFixture(core::LoadedVolume volume, const QSize& size = QSize(1200, 800));

    reference::ReferenceEngine engine;
    FakeFrames frames;
    ui::Workspace workspace;
    ui::MainWindow window;
};

} // namespace test
