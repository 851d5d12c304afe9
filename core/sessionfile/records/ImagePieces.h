// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>
#include <span>

namespace core {

/// Voxels of one piece of a session's images; the last one may have fewer. Even where nothing can
/// be compressed a piece stays below the 4 MiB of a blob.
constexpr std::size_t voxelsPerPiece = std::size_t(1) << 20;

/// zstd over the low bytes of all codes, then their high bytes: half the size of zstd over the
/// codes.
[[nodiscard]] QByteArray packedPiece(std::span<const std::uint16_t> codes);
/// @return false where @p bytes are no piece of so many codes
[[nodiscard]] bool unpackPiece(const QByteArray& bytes, std::span<std::uint16_t> codes);

/// Plain zstd of something small.
[[nodiscard]] QByteArray packed(const QByteArray& bytes);
/// None where it is no zstd, or more than @p most bytes.
[[nodiscard]] std::optional<QByteArray> unpacked(const QByteArray& bytes, qsizetype most);

/// Hex.
[[nodiscard]] QString sha256(const QByteArray& bytes);

} // namespace core
