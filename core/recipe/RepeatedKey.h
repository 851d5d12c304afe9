// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace core {

/// A key that occurs twice in a JSON object.
struct RepeatedKey {
    QString key;
    int line = 0; ///< of the second occurrence, from 1
};

/// The first key that occurs twice in an object of a JSON text. JSON readers silently keep the last
/// one.
/// @pre the text is valid JSON
[[nodiscard]] std::optional<RepeatedKey> repeatedKey(const QByteArray& json);

} // namespace core
