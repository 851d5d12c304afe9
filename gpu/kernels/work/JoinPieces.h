// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/engine/EngineEdit.h"

#include <variant>

namespace gpu {

/// Appends the second path to the first.
template <class Path> void append(Path& path, const Path& more)
{
    path.insert(path.end(), more.begin(), more.end());
}
/// Appends the path of the next extension to that of an earlier one of the same kind, if their kind
/// is Piece.
/// @return whether it did
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
