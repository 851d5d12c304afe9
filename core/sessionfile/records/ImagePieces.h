// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <cstdint>
#include <optional>
#include <span>

namespace core {

/// Number of voxels in one piece of a session's images; the last piece may have fewer. Even
/// incompressible voxels stay below the 4 MiB of a blob.
constexpr std::size_t voxelsPerPiece = std::size_t(1) << 20;

/// Compresses codes with zstd, first the low bytes of all, then the high bytes. The result is half
/// the size of zstd over the codes themselves.
[[nodiscard]] QByteArray packedPiece(std::span<const std::uint16_t> codes);
/// @return false if @p bytes are not a piece with that many codes
[[nodiscard]] bool unpackPiece(const QByteArray& bytes, std::span<std::uint16_t> codes);

/// Compresses something small with zstd.
[[nodiscard]] QByteArray packed(const QByteArray& bytes);
/// The reverse; none if it is not zstd or exceeds @p most bytes.
[[nodiscard]] std::optional<QByteArray> unpacked(const QByteArray& bytes, qsizetype most);

/// As hexadecimal digits.
[[nodiscard]] QString sha256(const QByteArray& bytes);

} // namespace core
