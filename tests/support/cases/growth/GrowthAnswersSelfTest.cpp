// SPDX-License-Identifier: Apache-2.0
#include "tests/support/cases/growth/GrowthAnswers.h"

#include "core/edits/kinds/Edit.h"
#include "core/edits/kinds/EditParts.h"
#include "core/edits/kinds/criteria/GrowCriteria.h"
#include "tests/support/cases/EngineCases.h"
#include "tests/support/cases/StrokeCases.h"
#include "tests/support/program/TestProgram.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>
#include <utility>

namespace growthAnswersSelfTest {

using test::EngineCase;
using test::GrowthAnswers;

namespace {

using Cases = std::vector<EngineCase>;
/// One question, its answer, another question, its answer; connectivity is the last question.
using Pair = std::tuple<std::size_t, int, std::size_t, int>;

std::set<Pair> pairsOf(const std::vector<GrowthAnswers>& all)
{
    std::set<Pair> pairs;
    const auto answer = [](const GrowthAnswers& answers, std::size_t question) {
        return question < test::growthQuestions ? int(answers.yes.test(question))
                                                : answers.connectivity;
    };
    for (const GrowthAnswers& each : all)
        for (std::size_t a = 0; a <= test::growthQuestions; ++a)
            for (std::size_t b = a + 1; b <= test::growthQuestions; ++b)
                pairs.emplace(a, answer(each, a), b, answer(each, b));
    return pairs;
}

/// The cases whose criteria are drawn, with the counts of EngineConformanceGlTest.
constexpr std::array<std::pair<Cases (*)(int), int>, 5> families{
    {{test::growLimitCases, 16}, {test::seedGroupCases, 16}, {test::overwrittenCases, 24},
        {test::passageCases, 8}, {test::wideGrowthCases, 24}}};

/// Every random growth of these cases, and of so many times as many.
std::vector<GrowthAnswers> drawn(int times)
{
    std::vector<GrowthAnswers> all;
    for (const auto& [family, count] : families) {
        const std::size_t named = family(0).size();
        const Cases cases = family(times * count);
        for (std::size_t i = named; i < cases.size(); ++i) {
            const std::vector<GrowthAnswers> answers = test::answersOf(cases[i]);
            all.insert(all.end(), answers.begin(), answers.end());
        }
    }
    return all;
}

std::size_t kindsOf(const std::vector<GrowthAnswers>& all)
{
    std::set<std::tuple<int, unsigned long>> kinds;
    for (const GrowthAnswers& each : all)
        kinds.emplace(each.connectivity, each.yes.to_ulong());
    return kinds.size();
}

} // namespace

/// A daily run compiles kernels for few kinds of growth, and yet no two of their answers go
/// untested together.
class GrowthAnswersSelfTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { m_long = qgetenv("BURIN_LONG"); }
    void cleanup() { qputenv("BURIN_LONG", m_long); }

    /// All that there are: two answers to each question, three connectivities.
    void fewAnswersHoldEveryPair()
    {
        const std::size_t binary = test::growthQuestions;
        QCOMPARE(
            pairsOf(test::dailyAnswers()).size(), binary * (binary - 1) / 2 * 4 + binary * 2 * 3);
        QCOMPARE(kindsOf(test::dailyAnswers()), test::dailyAnswers().size());
    }

    void randomGrowthsGiveTheseOnly()
    {
        qputenv("BURIN_LONG", "0");
        const std::vector<GrowthAnswers> everyDay = drawn(1);
        for (const GrowthAnswers& each : everyDay)
            QVERIFY(
                std::count(test::dailyAnswers().begin(), test::dailyAnswers().end(), each) == 1);
        qputenv("BURIN_LONG", "1");
        const std::vector<GrowthAnswers> atLength = drawn(6);
        qInfo("%d growths of %d kinds; at length %d of %d", int(everyDay.size()),
            int(kindsOf(everyDay)), int(atLength.size()), int(kindsOf(atLength)));
        QVERIFY(kindsOf(atLength) > 100);
        for (std::size_t i = 0; i < test::pairedAnswers; ++i)
            QVERIFY(std::count(everyDay.begin(), everyDay.end(), test::dailyAnswers()[i]) > 0);
        // And some pairs more: not every family of cases asks every question.
        const std::set<Pair> covered = pairsOf(everyDay);
        const std::set<Pair> wanted = pairsOf(atLength);
        QVERIFY(std::includes(covered.begin(), covered.end(), wanted.begin(), wanted.end()));
    }

    /// Neither how many there are, nor that all of them are sound.
    void nothingIsLost()
    {
        for (const auto& [family, count] : families) {
            qputenv("BURIN_LONG", "0");
            const Cases everyDay = family(count);
            qputenv("BURIN_LONG", "1");
            const Cases atLength = family(count);
            QCOMPARE(everyDay.size(), atLength.size());
            const std::size_t named = family(0).size();
            for (std::size_t i = 0; i < everyDay.size(); ++i) {
                QCOMPARE(everyDay[i].name, atLength[i].name);
                QCOMPARE(everyDay[i].steps.size(), atLength[i].steps.size());
                for (std::size_t step = 0; i >= named && step < everyDay[i].steps.size(); ++step) {
                    if (const auto* begin =
                            std::get_if<test::BeginGrowth>(&everyDay[i].steps[step]))
                        QVERIFY2(core::isSound(begin->burst), everyDay[i].name.constData());
                }
            }
        }
    }

    /// Edits that are told in a session grow by the same kinds.
    void strokesGiveTheseOnly()
    {
        qputenv("BURIN_LONG", "0");
        int growths = 0;
        for (const test::StrokeCase& stroke : test::strokeCases(60)) {
            if (!stroke.name.startsWith("random"))
                continue;
            std::vector<core::Edit> edits = stroke.before;
            edits.push_back(stroke.edit);
            for (const core::Edit& edit : edits) {
                if (!edit.is<core::GrowSteps>())
                    continue;
                const core::GrowCriteria& criteria = *core::growCriteriaOf(edit);
                GrowthAnswers answers{.connectivity = criteria.connectivity};
                const std::array<bool, test::growthQuestions> yes{criteria.difference.has_value(),
                    criteria.gradient.has_value(), criteria.gradientDifference.has_value(),
                    criteria.majority.value_or(0) > 1, criteria.smoothing.value_or(false),
                    criteria.onlyVisible, criteria.box.has_value(), criteria.sigmas.has_value(),
                    criteria.passage.has_value(), criteria.overwriteUnlocked};
                for (std::size_t i = 0; i < yes.size(); ++i)
                    answers.yes.set(i, yes[i]);
                QVERIFY(
                    std::count(test::dailyAnswers().begin(), test::dailyAnswers().end(), answers)
                    == 1);
                ++growths;
            }
        }
        QVERIFY2(growths > 20, qPrintable(QString::number(growths)));
    }

private:
    QByteArray m_long;
};

BURIN_PLAIN_TEST(GrowthAnswersSelfTest)

} // namespace growthAnswersSelfTest

#include "GrowthAnswersSelfTest.moc"
