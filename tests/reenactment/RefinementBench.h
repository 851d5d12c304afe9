// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/chunks/ChunkMap.h"
#include "core/metrics/MaskComparison.h"
#include "core/session/EditSession.h"
#include "tests/reenactment/MaskGrid.h"
#include "tests/reference/ReferenceEngine.h"

#include <memory>

namespace reenact {

/// A session on the oracle with one segment, label 1, which is to be mended.
class RefinementBench {
public:
    RefinementBench(core::LoadedVolume study, const Mask& mask);

    /// @return why it was refused, at once or later; empty: it was not
    [[nodiscard]] QString tried(const core::Edit& edit);
    [[nodiscard]] QString undone();

    [[nodiscard]] const core::VolumeGeometry& geometry() const { return m_geometry; }
    [[nodiscard]] core::EditSession& session() { return *m_session; }
    /// What is seen: the voxels within the surface, where there is one, else the segment's.
    [[nodiscard]] Mask seen() const;
    [[nodiscard]] Mask segment() const;
    [[nodiscard]] std::shared_ptr<const core::ChunkMap> chunks();

private:
    core::VolumeGeometry m_geometry;
    reference::ReferenceEngine m_engine;
    std::unique_ptr<core::EditSession> m_session;
};

/// What a user steers by, and what the table says: an organ as it is, and as the first surface
/// around it is in voxels (seed B, section 7.3).
struct Truth {
    Mask plain;
    Mask voxelised;

    /// @param vertices of that surface, about
    [[nodiscard]] static core::Result<Truth> of(
        const Mask& organ, const core::VolumeGeometry& geometry, int vertices);
    /// rVE, per cent.
    [[nodiscard]] double errorOf(const Mask& mask) const;
    [[nodiscard]] double plainErrorOf(const Mask& mask) const;
};

} // namespace reenact
