// Expectations about parts of texts.
#pragma once

#include <gtest/gtest.h>

#include <string>

/// Expects a text to contain a part, or not to; shows the text otherwise.
#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)
#define EXPECT_LACKS(text, part) EXPECT_EQ((text).find(part), std::string::npos) << (text)
