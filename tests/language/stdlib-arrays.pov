// The standard includes: arrays.inc.
#version 3.7;
global_settings { assumed_gamma 1 }
#include "arrays.inc"

//= Rand_Array_Item
#declare A = array[5] {3, 1, 4, 1, 5}
#declare S = seed(1);
#debug concat(str(Rand_Array_Item(A, S), 0, 9), "\n")
#debug concat(str(Rand_Array_Item(A, S), 0, 9), "\n")
#debug concat(str(Rand_Array_Item(A, S), 0, 9), "\n")
// expect: 4.000000000
// expect: 4.000000000
// expect: 1.000000000

//= Resize_Array
#declare A = array[5] {3, 1, 4, 1, 5}
Resize_Array(A, 3)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
Resize_Array(A, 6)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
// expect: 3 1 4
// expect: 3 1 4 - - -

//= Reverse_Array
#declare A = array[5] {3, 1, 4, 1, 5}
Reverse_Array(A)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
#declare A = array[4] {1, 2, 3, 4} Reverse_Array(A)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
// expect: 5 1 4 1 3
// expect: 4 3 2 1

//= Sort_Compare
#declare A = array[5] {3, 1, 4, 1, 5}
#debug concat(str(Sort_Compare(A, 0, 1), 0, 9), "\n")
#debug concat(str(Sort_Compare(A, 1, 0), 0, 9), "\n")
#debug concat(str(Sort_Compare(A, 1, 3), 0, 9), "\n")
// expect: 0.000000000
// expect: 1.000000000
// expect: 0.000000000

//= Sort_Swap_Data
#declare A = array[5] {3, 1, 4, 1, 5}
Sort_Swap_Data(A, 0, 1)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
// expect: 1 3 4 1 5

//= Sort_Array
#declare A = array[5] {3, 1, 4, 1, 5}
Sort_Array(A)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
#declare S = seed(3); #declare A = array[60] #for (I, 0, 59) #declare A[I] = int(100 * rand(S)); #end
Sort_Array(A)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
// expect: 1 1 3 4 5
// expect: 1 2 2 7 7 8 8 10 10 13 14 19 20 21
// expect: 24 24 26 28 29 30 34 35 40 42 43 44 46 47 47
// expect: 48 49 50 51 51 52 53 56 61 66 67 69 69 70 71
// expect: 71 72 74 74 76 78 82 89 90 90 94 94 95 97 97
// expect: 99

//= Sort_Partial_Array
#declare A = array[5] {3, 1, 4, 1, 5}
Sort_Partial_Array(A, 1, 3)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
// expect: 3 1 1 4 5

//= ARRAYS_InsertionSort
#declare A = array[5] {3, 1, 4, 1, 5}
ARRAYS_InsertionSort(A, 0, 4)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
// expect: 1 1 3 4 5

//= ARRAYS_HybridQuickSortStep leaves parts of ten as they are
#declare A = array[5] {3, 1, 4, 1, 5}
ARRAYS_HybridQuickSortStep(A, 0, 4)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
// expect: 3 1 4 1 5

//= Sort_Compare declared anew sorts the other way
#macro Sort_Compare(Array, IdxA, IdxB) (Array[IdxA] > Array[IdxB]) #end
#declare A = array[5] {3, 1, 4, 1, 5}
Sort_Array(A)
#for (I, 0, dimension_size(A, 1) - 1) #if (mod(I, 15) = 14) #debug "\n" #end #ifdef (A[I]) #debug concat(str(A[I], 0, 0), " ") #else #debug "- " #end #end #debug "\n"
// expect: 5 4 3 1 1

//= Sort_Swap_Data declared anew sorts rows
#macro Sort_Compare(Array, IdxA, IdxB) (Array[IdxA][0] < Array[IdxB][0]) #end
#macro Sort_Swap_Data(Array, IdxA, IdxB) #for (K, 0, 1) #local T = Array[IdxA][K]; #declare Array[IdxA][K] = Array[IdxB][K]; #declare Array[IdxB][K] = T; #end #end
#declare A = array[3][2] { {3, 30}, {1, 10}, {2, 20} }
Sort_Array(A)
#for (I, 0, 2) #debug concat(str(A[I][0], 0, 0), " ", str(A[I][1], 0, 0), "\n") #end
// expect: 1 10
// expect: 2 20
// expect: 3 30

//= ARRAYS_WriteDF3 and ARRAYS_Temp_WriteDF3
#declare A = array[2][3] { {0, 0.5, 1}, {0.25, 0.75, 0.1} }
ARRAYS_WriteDF3(A, "t.df3", 8)
ARRAYS_WriteDF3(A, "t16.df3", 16)
#debug concat(str(file_exists("t.df3") + file_exists("t16.df3"), 0, 9), "\n")
// expect: 2.000000000

//= ARRAYS_Temp, which in POV-Ray is seen only from within ARRAYS_WriteDF3
#declare A = array[2][3] { {0.1, 0.2, 0.3}, {0.4, 0.5, 0.6} }
ARRAYS_WriteDF3(A, "t.df3", 8)
#debug concat(str(ARRAYS_Temp(A, 1, 2, 7), 0, 9), "\n")
#debug concat(str(ARRAYS_Temp(A, 0, 1, 0), 0, 9), "\n")
// beyond
// expect: 0.600000000
// expect: 0.200000000
