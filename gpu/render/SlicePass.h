// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/render/parts/ChunkTextures.h"
#include "gpu/render/parts/Palette.h"
#include "gpu/scene/PassTarget.h"
#include "gpu/scene/Scene.h"

#include <array>

namespace gpu {

class VolumeTextures;

/// Draws any plane through the volume: window/level (DICOM LINEAR), fill and outline of segments,
/// outline of what is carved away, stripes where growth is shut out, a colour for what warns,
/// hatching over what a cut would take, chunks in colours of their own; a segment as it would be at
/// a tolerance where that is asked for and a field of it stands. Outside the volume it is black.
/// Interpolated by cubics where both scene and target say so.
class SlicePass {
public:
    /// Throws ShaderError. @param library outlives the pass
    explicit SlicePass(const ShaderLibrary& library);

    /// Makes everything ready for drawing a full-screen triangle. Cheap: called for every tile,
    /// since other work may come between two tiles.
    /// @param chunks of the scene; null: none to be drawn
    void prepare(VolumeTextures& volume, const SliceScene& scene, const SegmentDisplay& segments,
        const Palette& palette, const PassTarget& target, const ChunkTextures* chunks = nullptr);
    /// Likewise what a cutting plane of the 3D view shows (planePixel.glsl).
    /// @param look of a slice; where it lies is not looked at
    /// @param chunks of the look, in the colours of bodies; null: none to be drawn
    /// @return to be told where the plane is seen, and used
    [[nodiscard]] Program& prepareOnPlane(VolumeTextures& volume, const SliceScene& look,
        const SegmentDisplay& segments, const Palette& palette, const PassTarget& target,
        const ChunkTextures* chunks);

private:
    static constexpr unsigned variants = 128;
    /// Where it is drawn and how it is interpolated.
    enum Form : unsigned { Plain = 0, Cubic = 1, OnPlane = 2, CubicOnPlane = 3 };
    static constexpr unsigned forms = 4;

    [[nodiscard]] Program& prepareForm(unsigned form, VolumeTextures& volume,
        const SliceScene& scene, const SegmentDisplay& segments, const Palette& palette,
        const PassTarget& target, const ChunkTextures* chunks);
    /// @param variant labels or none, plus twice carved or not, plus four times barriers or none,
    /// plus eight times members that warn or none, plus sixteen times a segment at a tolerance or
    /// none, plus 32 times what a cut would take or none, plus 64 times chunks or none
    [[nodiscard]] Program& programFor(unsigned form, unsigned variant);

    const ShaderLibrary& m_library;
    /// By form and variant; all but the first eight when they are first needed.
    std::array<std::array<Program, variants>, forms> m_programs;
};

} // namespace gpu
