// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/frame/Scene.h"
#include "gpu/gl/Texture2D.h"

namespace gpu {

/// Colour of each label and whether it is shown, 256 × 1, RGBA8 (alpha 1: shown).
class Palette {
public:
    Palette();

    void set(const SegmentDisplay& segments);
    [[nodiscard]] const Texture2D& texture() const { return m_texture; }

private:
    Texture2D m_texture;
    SegmentDisplay m_current;
};

} // namespace gpu
