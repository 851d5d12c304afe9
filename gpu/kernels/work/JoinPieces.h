// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineEdit.h"

#include <variant>

namespace gpu {

/// Puts the second path behind the first.
template <class Path> void append(Path& path, const Path& more)
{
    path.insert(path.end(), more.begin(), more.end());
}
/// Puts the next piece of a path behind an earlier one, extensions of one kind.
/// @return whether that is a kind of such pieces
template <class Piece, class Path>
[[nodiscard]] bool joinPieces(
    core::EngineExtension& earlier, core::EngineExtension& next, Path Piece::*path)
{
    auto* first = std::get_if<Piece>(&earlier);
    if (first)
        append(first->*path, std::get<Piece>(next).*path);
    return first != nullptr;
}

} // namespace gpu
