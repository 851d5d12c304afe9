// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QCoreApplication>
#include <QTranslator>

namespace test {

/// While it lives every text that goes through tr() stands in angle brackets; that for many tells
/// before it how many they were.
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
