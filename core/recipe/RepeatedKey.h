// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

#include <optional>

namespace core {

struct RepeatedKey {
    QString key;
    int line = 0; ///< of the second one, from 1
};

/// The first key that an object of a JSON text has twice; readers keep the last one without a word.
/// @pre the text is JSON
[[nodiscard]] std::optional<RepeatedKey> repeatedKey(const QByteArray& json);

} // namespace core
