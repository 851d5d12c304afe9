// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/Program.h"
#include "gpu/gl/Texture2D.h"
#include "gpu/scene/ColourMap.h"

namespace gpu {

/// The colours of grey values as an RGBA8 texture of 256 × 1 texels (render/parts/colourMap.glsl).
class ColourTable {
public:
    ColourTable();

    /// Binds the texture and sets which colour map a program shows. For Grey the shader skips the
    /// look-up, so pixels stay exactly as they are.
    void bind(Program& program, ColourMap map);

private:
    Texture2D m_texture;
    /// The map that the texture holds; Grey is never uploaded.
    ColourMap m_current = ColourMap::Grey;
};

} // namespace gpu
