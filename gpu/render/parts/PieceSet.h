// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Buffer.h"
#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/scene/Scene.h"

#include <vector>

namespace gpu {

class VolumeTextures;

/// The pieces (core::Piece) of a scene as the ray caster reads them (pieces.glsl). Engine thread.
class PieceSet {
public:
    PieceSet();

    /// Takes the pieces of the scene that have something to show.
    /// @return whether there are any
    bool set(VolumeTextures& volume, const VolumeScene& scene, double stepMm);
    /// Whether some pieces are at the place where they were cut and look like the rest.
    [[nodiscard]] bool anyAtHome() const { return m_home > 0; }
    /// Binds the pieces for a program of the variant PIECES.
    void bind(Program& program, VolumeTextures& volume) const;

    /// The least zoom of any piece, at most 1 and at least 0.25. A piece that is shown smaller is
    /// sampled with longer steps at its true place, so the steps of a ray must be shortened by this
    /// factor.
    [[nodiscard]] static double finestZoom(const VolumeScene& scene);

private:
    void setTransfers(const std::vector<const ScenePiece*>& rows, double stepMm);

    Buffer m_buffer;
    Texture2D m_transfers;
    std::vector<TransferFunction> m_rows; ///< the functions in m_transfers
    double m_stepMm = 0.0;
    int m_count = 0;
    int m_home = 0;
};

} // namespace gpu
