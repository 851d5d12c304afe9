// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace test {

/// Makes every unannounced warning or critical message a failure of the following test function:
/// what Qt, a driver or our own code reports is a defect. Call it in init().
///
/// Announce an expected message with QTest::ignoreMessage(QtWarningMsg, …); a critical one counts
/// as a warning here. Messages about the machine instead of Burin pass; the source lists them.
/// Messages of any thread count.
void failOnUnexpectedMessages();

} // namespace test
