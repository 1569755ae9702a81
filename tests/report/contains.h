#pragma once

#include <gtest/gtest.h>

#include <string>

/// Expects a text to contain a part; shows the text otherwise.
#define EXPECT_CONTAINS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)
