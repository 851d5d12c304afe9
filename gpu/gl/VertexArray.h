// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "gpu/gl/GlId.h"

namespace gpu {

/// An empty vertex array: the core profile wants one even where the vertex shader makes its own
/// vertices. Lives with one context (not shared).
class VertexArray {
public:
    VertexArray() = default;
    explicit VertexArray(const char* label);

    /// One triangle that covers the viewport, with the program in use (fullScreen.vert).
    void drawFullScreenTriangle() const;

private:
    GlId<glDelete::vertexArray> m_id;
};

} // namespace gpu
