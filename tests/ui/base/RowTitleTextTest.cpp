// SPDX-License-Identifier: Apache-2.0
#include "ui/base/RowTitleText.h"

#include "core/titles/TitleForms.h"
#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace rowTitleTextTest {

using core::RowTitle;
using core::RowTitleCode;

namespace {

/// With something in every place that a text may have.
RowTitle filled(RowTitleCode code, std::int64_t count)
{
    return {.code = code,
        .arguments = {core::TitleCount{count}, QStringLiteral("A, %1"), core::inMm(2.5)},
        .then = {{.code = RowTitleCode::Voxels, .arguments = {core::TitleCount{count}}}}};
}

} // namespace

/// The window words rows as their stored names do where nothing is translated, and else in its
/// language.
class RowTitleTextTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void untranslatedItIsTheName()
    {
        for (int code = 0; core::formOf(RowTitleCode(code)).id; ++code) {
            for (const std::int64_t count : {0, 1, 2, 18204}) {
                const RowTitle title = filled(RowTitleCode(code), count);
                QCOMPARE(ui::textOf(title), core::canonicalName(title));
            }
        }
        for (const RowTitleCode code : {RowTitleCode::MoveSegment, RowTitleCode::MoveLayer}) {
            const RowTitle title{
                .code = code, .arguments = {QStringLiteral("A"), core::TitleNumber{3}}};
            QCOMPARE(ui::textOf(title), core::canonicalName(title));
        }
        const std::vector<RowTitle> two{{.code = RowTitleCode::ThroughGaps},
            {.code = RowTitleCode::RadiusTo, .arguments = {core::inMm(1.0), core::inMm(2.0)}}};
        for (const RowTitleCode code : {RowTitleCode::Changes, RowTitleCode::Reasons}) {
            const RowTitle title{.code = code, .arguments = {two}};
            QCOMPARE(ui::textOf(title), core::canonicalName(title));
        }
    }

    void everyTextGoesThroughTheTranslator()
    {
        const test::MarkingTranslator translator;
        for (int code = 0; core::formOf(RowTitleCode(code)).id; ++code) {
            const QByteArray text = core::formOf(RowTitleCode(code)).text;
            const bool isWords = !text.isEmpty() && text != "%1";
            for (const std::int64_t count : {1, 2}) {
                RowTitle title = filled(RowTitleCode(code), count);
                title.then.clear();
                QCOMPARE(ui::textOf(title).contains(u'<'), isWords);
            }
        }
        QCOMPARE(
            ui::textOf({.code = RowTitleCode::Drill,
                .arguments = {core::inMm(6.2)},
                .then = {{.code = RowTitleCode::Bricks, .arguments = {core::TitleCount{214}}}}}),
            QStringLiteral("<Drill 6.2 mm><, >214<214 bricks>"));
    }

    void aRowWithoutATitleShowsItsName()
    {
        core::HistoryRow row;
        row.name = QStringLiteral("Something of before");
        QCOMPARE(ui::nameOf(row), row.name);
        row.title = RowTitle{.code = RowTitleCode::PlugLeak};
        QCOMPARE(ui::nameOf(row), QStringLiteral("Plug leak"));
    }
};

BURIN_TEST(RowTitleTextTest)

} // namespace rowTitleTextTest

#include "RowTitleTextTest.moc"
