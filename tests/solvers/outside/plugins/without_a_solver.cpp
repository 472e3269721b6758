extern "C" const int ricochet_plugout = 1;
