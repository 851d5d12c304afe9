// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QTranslator>

namespace test {

/// Puts every text that goes through tr() into angle brackets during its lifetime. Texts with a
/// count are preceded by that count.
class MarkingTranslator : public QTranslator {
public:
    MarkingTranslator() { QCoreApplication::installTranslator(this); }
    ~MarkingTranslator() override { QCoreApplication::removeTranslator(this); }
    MarkingTranslator(const MarkingTranslator&) = delete;
    MarkingTranslator& operator=(const MarkingTranslator&) = delete;

    [[nodiscard]] QString translate(
        const char*, const char* text, const char*, int count) const override
    {
        const QString marked = u'<' + QString::fromUtf8(text) + u'>';
        return count < 0 ? marked : QString::number(count) + marked;
    }
    [[nodiscard]] bool isEmpty() const override { return false; }
};

} // namespace test
