#include "schema/catalogue.hpp"
