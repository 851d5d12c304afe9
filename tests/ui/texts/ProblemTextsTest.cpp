// SPDX-License-Identifier: Apache-2.0
#include "ui/texts/ProblemTexts.h"

#include "tests/support/program/MarkingTranslator.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

namespace problemTextsTest {

using core::ProblemCode;
using core::ProblemSentence;

namespace {

const std::vector<ProblemCode>& everyCode()
{
    static const std::vector<ProblemCode> codes{
#define PROBLEM_SENTENCE(code, ...) ProblemCode::code,
#include "core/volume/ProblemSentences.def"
#undef PROBLEM_SENTENCE
    };
    return codes;
}

/// With a count, a name that looks like the place of an argument, a list, and more than any form
/// has places for.
ProblemSentence sentenceOf(ProblemCode code, std::int64_t count)
{
    return {code,
        {count, QStringLiteral("B %1 %2"),
            core::namesIn({QStringLiteral("c"), QStringLiteral("d")}, ProblemCode::AndOf),
            QStringLiteral("e"), core::asPart({ProblemCode::OneSlice, {QStringLiteral("7")}})}};
}

} // namespace

/// What window and command line say of the problems of a volume.
class ProblemTextsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    /// Without a translation the words are those that session files keep.
    void everyCodeAsItIsStored()
    {
        for (const ProblemCode code : everyCode()) {
            for (const std::int64_t count : {0, 1, 2, 17}) {
                const ProblemSentence sentence = sentenceOf(code, count);
                QVERIFY(!core::storedText(sentence).isEmpty());
                QCOMPARE(ui::problemText(sentence), core::storedText(sentence));
            }
        }
    }

    void everyCodeGoesThroughTheTranslator()
    {
        const test::MarkingTranslator translator;
        for (const ProblemCode code : everyCode()) {
            for (const std::int64_t count : {1, 2}) {
                const ProblemSentence sentence = sentenceOf(code, count);
                const QString said = ui::problemText(sentence);
                const QString begin = QString(said).remove(QString::number(count) + u'<');
                const bool isMarked =
                    (said.startsWith(u'<') || said.size() > begin.size()) && said.endsWith(u'>');
                QCOMPARE(isMarked, code != ProblemCode::AsStored);
                QVERIFY(!core::storedText(sentence).contains(u'<'));
            }
        }
    }

    void lists()
    {
        const ProblemSentence missing{ProblemCode::SlicesMissing,
            {3,
                core::withCommas({{ProblemCode::SlicesMissingBetween,
                                      {1, 4, 5, QStringLiteral("2"), QStringLiteral("1")}},
                    {ProblemCode::SlicesMissingBetween,
                        {2, 9, 10, QStringLiteral("3"), QStringLiteral("1")}}})}};
        QCOMPARE(core::storedText(missing),
            QStringLiteral("3 slices are missing: 1 between slices 4 and 5 (2 mm instead of 1), "
                           "2 between slices 9 and 10 (3 mm instead of 1)."));
        const ProblemSentence undecoded{ProblemCode::UndecodedLeftOut,
            {ProblemSentence::Listed{.joiner = ProblemCode::Semicolon,
                .all = {{ProblemCode::FirstUndecoded,
                            {2, QStringLiteral("a.dcm"), QStringLiteral("cut short")}},
                    {ProblemCode::NextUndecoded,
                        {5, QStringLiteral("b.dcm"), QStringLiteral("cut short")}},
                    {ProblemCode::UndecodedMore, {4}}}}}};
        QCOMPARE(core::storedText(undecoded),
            QStringLiteral("Slice 2 (a.dcm) could not be decoded: cut short; slice 5 (b.dcm) could "
                           "not be decoded: cut short; and 4 more. They were left out."));
        QCOMPARE(ui::problemText(undecoded), core::storedText(undecoded));
    }
};

BURIN_TEST(ProblemTextsTest)

} // namespace problemTextsTest

#include "ProblemTextsTest.moc"
