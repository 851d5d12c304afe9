// SPDX-License-Identifier: Apache-2.0
#include "core/base/words/Said.h"

namespace core {

QString filledIn(const QString& text, const QStringList& arguments)
{
    QString filled;
    for (qsizetype i = 0; i < text.size(); ++i) {
        const int place = text[i] == u'%' && i + 1 < text.size() ? text[i + 1].digitValue() : 0;
        if (place < 1 || place > arguments.size()) {
            filled += text[i];
            continue;
        }
        filled += arguments[place - 1];
        ++i;
    }
    return filled;
}

} // namespace core
