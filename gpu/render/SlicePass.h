// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/Scene.h"
#include "gpu/gl/Program.h"
#include "gpu/render/ChunkTextures.h"
#include "gpu/render/Palette.h"
#include "gpu/render/PassTarget.h"

#include <array>

namespace gpu {

class VolumeTextures;

/// Draws any plane through the volume: window/level (DICOM LINEAR), fill and outline of segments,
/// outline of what is carved away, stripes where growth is shut out, a colour for what warns,
/// hatching over what a cut would take, chunks in colours of their own; a segment as it would be at
/// a tolerance where that is asked for and a field of it stands. Outside the volume it is black.
class SlicePass {
public:
    /// Throws ShaderError. @param library outlives the pass
    explicit SlicePass(const ShaderLibrary& library);

    /// Makes everything ready for drawing a full-screen triangle. Cheap: called for every tile,
    /// since other work may come between two tiles.
    /// @param chunks of the scene; null: none to be drawn
    void prepare(VolumeTextures& volume, const SliceScene& scene, const SegmentDisplay& segments,
        const Palette& palette, const PassTarget& target, const ChunkTextures* chunks = nullptr);

private:
    /// @param variant labels or none, plus twice carved or not, plus four times barriers or none,
    /// plus eight times members that warn or none, plus sixteen times a segment at a tolerance or
    /// none, plus 32 times what a cut would take or none, plus 128 times chunks or none
    [[nodiscard]] Program& programFor(unsigned variant);

    const ShaderLibrary& m_library;
    std::array<Program, 256> m_programs; ///< from eight on when they are first needed
};

} // namespace gpu
