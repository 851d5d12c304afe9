// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>
#include <string_view>

namespace core {

/// Text of a data set in Unicode.
///
/// @param characterSet value of SpecificCharacterSet (0008,0005). Where it cannot be converted, the
/// bytes are taken as Latin-1: a name that looks odd is better than a study that does not open.
[[nodiscard]] QString dicomText(const QByteArray& bytes, const QByteArray& characterSet);

/// A decimal string (VR DS or IS) in the way of PS3.5, whatever the locale; none if it is no
/// number.
[[nodiscard]] std::optional<double> dicomNumber(std::string_view text);

/// "20240131" → "2024-01-31"; other texts unchanged.
[[nodiscard]] QString dicomDate(const QString& date);

} // namespace core
