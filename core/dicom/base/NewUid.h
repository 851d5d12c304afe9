// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QString>

namespace core {

/// A new unique identifier under 2.25: the decimal of a random UUID (PS3.5 B.2). Any thread.
QString newUid();

/// The unique identifier under 2.25 of 16 bytes.
QString uidOf(QByteArray bytes);

} // namespace core
