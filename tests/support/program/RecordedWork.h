// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QByteArray>
#include <QStringList>

#include <cstdint>
#include <utility>
#include <vector>

namespace test {

/// The cost of a step in counted things (calls, bytes), which is the same on every machine.
struct CountedStep {
    QByteArray name; ///< unique among the steps of a record
    std::vector<std::pair<QByteArray, std::int64_t>> counts; ///< each with its name
};

/// Returns a record of steps, one line for each.
[[nodiscard]] QByteArray recordOf(const std::vector<CountedStep>& steps);
/// Compares steps with a record.
/// @return a sentence for each count that has grown, and for each step that only one of the two has
[[nodiscard]] QStringList grownSince(
    const QByteArray& record, const std::vector<CountedStep>& steps);

/// Compares steps with a record in tests/data/work. If BURIN_RECORD_WORK is set, it overwrites the
/// record with them instead.
/// @param file name of the record
/// @return as for grownSince()
[[nodiscard]] QStringList grownSinceRecorded(
    const QString& file, const std::vector<CountedStep>& steps);

/// Which counts of a step are greater than they may be.
class TooMuch {
public:
    /// @param where "the large volume"
    TooMuch(const QByteArray& step, const char* where);
    void demand(const char* what, std::int64_t found, std::int64_t most);
    [[nodiscard]] const QStringList& sentences() const { return m_sentences; }

private:
    QByteArray m_step;
    const char* m_where;
    QStringList m_sentences;
};

} // namespace test
