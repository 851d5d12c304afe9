// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>
#include <string_view>

namespace core {

/// Whether text is the same in every character set: ASCII without escape sequences.
[[nodiscard]] bool isPlainText(const QByteArray& bytes);

/// Converts text of a data set to Unicode.
///
/// @param characterSet value of SpecificCharacterSet (0008,0005). If the text cannot be converted,
/// it is taken as UTF-8, and if it is none, its bytes are taken as Latin-1: a wrong-looking name is
/// better than a study that does not open.
[[nodiscard]] QString dicomText(const QByteArray& bytes, const QByteArray& characterSet);

/// A decimal string (VR DS or IS) as defined in PS3.5, independent of the locale; none if it is not
/// a number.
[[nodiscard]] std::optional<double> dicomNumber(std::string_view text);

/// "20240131" → "2024-01-31"; other texts unchanged.
[[nodiscard]] QString dicomDate(const QString& date);

} // namespace core
