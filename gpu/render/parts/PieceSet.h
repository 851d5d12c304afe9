// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Buffer.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/scene/Scene.h"

#include <vector>

namespace gpu {

class VolumeTextures;

/// The pieces of a scene as the ray caster reads them (pieces.glsl). Engine thread.
class PieceSet {
public:
    PieceSet();

    /// Takes those that have something to show. @return whether there are any
    bool set(VolumeTextures& volume, const VolumeScene& scene, double stepMm);
    /// Whether some are where they were cut and look as if they were not.
    [[nodiscard]] bool anyAtHome() const { return m_home > 0; }
    /// Binds them for a program of the variant PIECES.
    void bind(Program& program, VolumeTextures& volume) const;

    /// A zoom of less than 1 makes steps longer at the true place: how much shorter they must be.
    [[nodiscard]] static double finestZoom(const VolumeScene& scene);

private:
    void setTransfers(const std::vector<const ScenePiece*>& rows, double stepMm);

    Buffer m_buffer;
    Texture2D m_transfers;
    std::vector<TransferFunction> m_rows; ///< of m_transfers
    double m_stepMm = 0.0;
    int m_count = 0;
    int m_home = 0;
};

} // namespace gpu
